# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()

# %% how it moves: centre of rotation, centre of mass, angles, velocity, omega, three numbers each
motion = case.table("motion", "barge.dat")
values = motion.values.reshape(len(motion.time), -1)
sway, heave = 1e3 * values[:, 3], 1e3 * values[:, 4]
theory = np.genfromtxt("reference/potential_theory.csv", delimiter=",", comments="#")
print(f"largest distance to potential theory in sway "
      f"{np.abs(sway - np.interp(motion.time, theory[:, 0], theory[:, 1])).max():.2f}, "
      f"in heave {np.abs(heave - np.interp(motion.time, theory[:, 0], theory[:, 2])).max():.2f} mm")
if plt:
    plt.plot(theory[:, 0], theory[:, 1:])
    plt.plot(motion.time, sway)
    plt.plot(motion.time, heave)
    plt.savefig("notebook_motion.png")
    plt.close()
