# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()
H, shift = 0.3, 0.055  # depth of the column; the experiment's clock starts with the gate (see README)


def star(t):
    return t * np.sqrt(9.81 / H) + shift


# %% front
front = case.table("front", "front.dat")
experiment = np.loadtxt("reference/front_position_H300.csv", delimiter=",", skiprows=2)
inside = experiment[experiment[:, 0] < star(front.time[-1])]
ours = np.interp(inside[:, 0], star(front.time), (front["front"] - 0.6) / H)
print(f"front: largest difference to the experiment {abs(ours - inside[:, 1]).max():.3f} H")

# %% pressure at the sensors, and the impulse that they feel
sensors = case.table("sensors", "pFiltered")
p = np.nan_to_num(sensors.values) / (997 * 9.81 * H)  # dry: nan
for k, place in enumerate(sensors.points):
    impulse = 0.5 * ((p[1:, k] + p[:-1, k]) * np.diff(star(sensors.time))).sum()
    print(f"sensor at {1e3 * place[1]:.0f} mm: peak {p[:, k].max():.2f}, impulse {impulse:.2f}")
if plt:
    plt.plot(star(sensors.time), p)
    plt.xlabel("t*")
    plt.ylabel("p*")
    plt.savefig("notebook_pressure.png")
    plt.close()

# %% wetted length of the floor from the last time folder
last = case.read("latest").fluid
onFloor = np.abs(last.points[:, 1]) < 1e-9
print(f"water on the floor up to x = {last.points[onFloor, 0].max():.3f} m at {last.time:g} s")
