# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()
B = 50 / (1000 * 9.81)  # tau0 / (rho g)

# %% the slope of h^2 - pi B h between 0.1 and 0.7 m over that at rest, -2 B
depth = case.table("depth", "elevation")
x = np.array([place[0] for place in depth.points])
inner = (x > 0.05) & (x < 0.75)
for t in (2, 5, 10):
    h = depth.values[np.argmin(abs(depth.time - t))][inner]
    if np.all(np.isfinite(h)):
        slope = np.polyfit(x[inner], h**2 - np.pi * B * h, 1)[0]
        print(f"slope at {t:2d} s: {-slope / (2 * B):.3f} of that at rest")

# %% how much of the mud is slower than 1 mm/s at the end
last = case.read(case.times[-1]).fluid
speed = np.linalg.norm(last.point["U"], axis=1)
print(f"{100 * np.mean(speed < 1e-3):.0f} % of the nodes are slower than 1 mm/s")
if plt:
    for t in (0.5, 1, 10):
        plt.plot(x, depth.values[np.argmin(abs(depth.time - t))], label=f"{t} s")
    plt.legend()
    plt.savefig("notebook_depth.png")
    plt.close()
