# The results of this study as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import pathlib

import numpy as np
import pfem

plt = pfem.pyplot()
theory = -6.849e-5  # thin plate [m]

# %% deflection of the middle
for folder in sorted(pathlib.Path("study").iterdir()):
    if not folder.is_dir():
        continue
    mid = pfem.Case(folder).table("mid", "D")
    uy = mid.values[:, 0, 1]
    print(f"{folder.name:15s} u_y = {uy[-1]:.4e} m at {mid.time[-1]:g} s, {uy[-1] / theory:.3f} of the thin plate's")
    if plt:
        plt.plot(mid.time, uy, label=folder.name)
if plt:
    plt.legend()
    plt.savefig("notebook_deflection.png")
    plt.close()

# %% the pressure of the water at rest against rho g times the depth
fluid = pfem.Case("study/nodal-4").read("latest").fluid
surface = fluid.points[:, 1].max()
exact = 1000 * 9.81 * (surface - fluid.points[:, 1])
print(f"largest difference of p to the hydrostatic one: {np.abs(fluid.point['p'] - exact).max():.1f} Pa of {exact.max():.0f} Pa")
