# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()

# %% the wall's tip beside a published curve
tip = case.table("tip", "D")
ux = tip.values[:, 0, 0]
print(f"first maximum of u_x: {ux.max():.4f} m at {tip.time[ux.argmax()]:.3f} s")
published = np.loadtxt("reference/tip_ux_meduri2018.csv", delimiter=",", skiprows=2)
both = published[(published[:, 0] > 0.15) & (published[:, 0] < tip.time[-1])]
if len(both):
    difference = np.interp(both[:, 0], tip.time, ux) - both[:, 1]
    print(f"rms difference to Meduri et al. 2018: {np.sqrt(np.mean(difference ** 2)):.4f} m")
if plt:
    plt.plot(tip.time, ux, label="this run")
    plt.plot(*published.T, label="Meduri et al. 2018")
    plt.legend()
    plt.savefig("notebook_tip.png")
    plt.close()

# %% the fluid's mass
mass = case.table("mass", "fluidVolume.dat")
print(f"largest change of the fluid's volume: {100 * abs(mass['relativeChange']).max():.3f} %")

# %% the state when the wall is bent most
step = case.read(float(tip.time[ux.argmax()]))
stress = pfem.vonMises(step.solid.point["sigma"])
print(f"at {step.time:g} s: largest von Mises stress {stress.max():.0f} Pa, "
      f"largest vorticity {abs(pfem.vorticity(step.fluid)).max():.0f} 1/s")
if plt:
    pfem.triangles(plt, step.fluid, pfem.magnitude(step.fluid.point["U"]), cmap="Blues")
    plt.colorbar(pfem.triangles(plt, step.solid, stress, cmap="inferno"), label="von Mises stress [Pa]")
    plt.savefig("notebook_stress.png", dpi=150)
    plt.close()

# %% paths of twenty particles of the water
first = case.read("0").fluid
ids = first.point["id"][:: max(1, len(first.points) // 20)]
time, paths = case.trace(ids)
print(f"{np.isfinite(paths[-1, :, 0]).sum()} of {len(ids)} traced particles are still there at {time[-1]:g} s")
