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
heave, roll = values[:, 4] / 0.005, 1 + values[:, 8] / 5
theory = np.genfromtxt("reference/potential_theory.csv", delimiter=",", comments="#")
print(f"largest distance to potential theory in heave "
      f"{np.abs(heave - np.interp(motion.time, theory[:, 0], theory[:, 1])).max():.2f}, "
      f"in roll {np.abs(roll - np.interp(motion.time, theory[:, 0], theory[:, 2])).max():.2f} of the first value")
if plt:
    plt.plot(theory[:, 0], theory[:, 1:])
    plt.plot(motion.time, heave)
    plt.plot(motion.time, roll)
    plt.savefig("notebook_motion.png")
    plt.close()
