# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()
impact = np.sqrt(2 * 1.3 / 9.81)

# %% velocity beside the experiment
apex = case.table("apex", "U")
v, t = -apex.values[:, 0, 1], 1e3 * (apex.time - impact)
print(f"velocity at the impact: {np.interp(0, t, v):.3f} m/s, free fall {9.81 * impact:.3f} m/s")
experiment = np.loadtxt("reference/velocity_experiment_yettou.csv", delimiter=",", skiprows=2)
both = experiment[(experiment[:, 0] >= 0) & (experiment[:, 0] <= min(40, t[-1]))]
if len(both):
    difference = np.interp(both[:, 0], t, v) - both[:, 1]
    print(f"rms difference to the experiment: {np.sqrt(np.mean(difference ** 2)):.3f} m/s")

# %% pressure coefficient along the face at the last time that was written
step = case.read("latest")
face = case.table("face", "pFiltered")
coefficient = face.values / (0.5 * 1000 * np.interp(face.time, apex.time, v)[:, None] ** 2)
print(f"highest pressure coefficient: {np.nanmax(coefficient):.2f}")
if plt:
    plt.plot(1e3 * (face.time - impact), coefficient)
    plt.xlabel("time after the impact [ms]")
    plt.savefig("notebook_pressure.png")
    plt.close()

# %% the water that has been thrown up
fluid = step.fluid
print(f"highest water at {fluid.time:g} s: {fluid.points[:, 1].max():.3f} m; in isolated drops: "
      f"{1e4 * fluid.point['dropVolume'].sum():.3f} cm2")
