# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()

# %% velocity along the floor of each block; centre of rotation, centre of mass, angles, velocity, omega, three numbers each
speed = {}
for block in ("first", "second", "third"):
    motion = case.table("motion", f"{block}.dat")
    speed[block] = motion.values.reshape(len(motion.time), -1)[:, 9]
momentum = sum(speed.values())  # over the mass of one
friction = -np.gradient(momentum, motion.time)  # 2 mu g before the first impact has struck: mu g for each that slides
print(f"momentum over the mass of a block: {momentum[0]:.3f} m/s at first, {momentum[-1]:.3f} at last")
print(f"deceleration of all together: {friction[5:50].mean():.3f} m/s2 before the first impact (mu g = {0.2 * 9.81:.3f})")
if plt:
    for block, v in speed.items():
        plt.plot(motion.time, v, label=block)
    plt.legend()
    plt.savefig("notebook_motion.png")
    plt.close()
