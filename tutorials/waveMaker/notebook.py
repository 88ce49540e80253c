# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()

# %% wave heights of the last three periods at the gauges
gauges = case.table("gauges", "elevation")
last = gauges.time > gauges.time[-1] - 3
for k, place in enumerate(gauges.points):
    y = gauges.values[last, k]
    print(f"wave height at {place[0]:.1f} m: {1e3 * (np.nanmax(y) - np.nanmin(y)):.2f} mm")

# %% mean power of the piston over the last three periods: force times velocity of x = 0.01 sin(2 pi t)
force = case.table("force", "force.dat")
fx = -next(iter(force.columns.values()))[:, 0]  # of the piston on the water
late = force.time > force.time[-1] - 3
power = (fx * 0.01 * 2 * np.pi * np.cos(2 * np.pi * force.time))[late]
print(f"mean power of the piston: {np.average(power):.3f} W/m")
if plt:
    plt.plot(gauges.time, gauges.values, label=[f"{x[0]} m" for x in gauges.points])
    plt.legend()
    plt.savefig("notebook_waves.png")
    plt.close()

# %% how far particles at the surface drift (Stokes drift)
first = case.read("0").fluid
ids = first.point["id"][(first.points[:, 1] > 0.3 - 1e-6) & (first.points[:, 0] > 1) & (first.points[:, 0] < 2)]
time, paths = case.trace(ids)
print(f"mean drift of {len(ids)} surface particles until {time[-1]:g} s: {1e3 * np.nanmean(paths[-1, :, 0] - paths[0, :, 0]):.2f} mm")
