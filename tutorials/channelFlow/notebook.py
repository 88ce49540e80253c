# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()
H, U, mu = 0.1, 0.1, 0.5

# %% the profile in the last time folder
step = case.read(case.times[-1])
y = np.linspace(0.002, 0.098, 49)
u = step.sample(np.column_stack([np.full(len(y), 0.15), y]), "U")[:, 0]
exact = 6 * U * y * (H - y) / H**2
print(f"largest error {100 * np.abs(u - exact).max() / (1.5 * U):.2f} % of the fastest velocity")
if plt:
    plt.plot(exact, y, label="closed form")
    plt.plot(u, y, label="this run")
    plt.legend()
    plt.savefig("notebook_profile.png")
    plt.close()

# %% the pressure along the axis
p = case.table("axis", "p")
mean = p.values[len(p.time) // 2:].mean(axis=0).reshape(-1)
print(f"slope {np.polyfit(0.05 * np.arange(1, 6), mean, 1)[0]:.2f} Pa/m, closed form {-12 * mu * U / H**2:.2f} Pa/m")
