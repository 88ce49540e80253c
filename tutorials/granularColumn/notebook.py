# The results of this study as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

plt = pfem.pyplot()
L = 0.1

# %% how far the columns run out, over sqrt(H/g)
for a in (0.5, 1, 2, 4):
    front = pfem.Case(f"study/a{a}").table("front", "front.dat")
    x = front["front"]
    runOut = (x - L) / L
    print(f"a = {a}: run-out {runOut[-1]:.3f} L, {runOut[-1] / a:.3f} a")
    if plt:
        plt.plot(front.time / np.sqrt(a * L / 9.81), runOut / a, label=f"a = {a}")
if plt:
    plt.legend()
    plt.savefig("notebook_front.png")
    plt.close()

# %% the heap of the column with a = 1 at rest: its slope at half of its length
grains = pfem.Case("study/a1").read("latest").fluid
x, y = grains.points[:, 0], grains.points[:, 1]
edges = np.linspace(0, x.max(), 15)
middle = 0.5 * (edges[1:] + edges[:-1])
height = np.array([y[(x >= low) & (x <= high)].max(initial=0) for low, high in zip(edges, edges[1:])])
slope = np.polyfit(middle[4:10], height[4:10], 1)[0]
print(f"slope of the heap at half of its length: {-slope:.3f}, static friction muS 0.38")
