# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import numpy as np
import pfem

case = pfem.Case()
plt = pfem.pyplot()
k = np.pi
period = 2 * np.pi / np.sqrt(9.81 * k * np.tanh(0.5 * k))

# %% the period from the zeros of the edge's elevation
gauge = case.table("gauge", "D")
y = gauge.values[:, 0, 1] - gauge.values[:, 0, 1].mean()
at = np.flatnonzero(np.diff(np.sign(y)) != 0)
zeros = gauge.time[at] - y[at] * np.diff(gauge.time)[at] / np.diff(y)[at]
if len(zeros) > 1:
    print(f"period {2 * np.polyfit(np.arange(len(zeros)), zeros, 1)[0]:.4f} s, closed form {period:.4f} s")
if plt:
    plt.plot(gauge.time, y, label="this run")
    plt.plot(gauge.time, 0.01 * np.cos(2 * np.pi * gauge.time / period), label="linear theory")
    plt.legend()
    plt.savefig("notebook_wave.png")
    plt.close()

# %% the velocity field of the first mode: horizontal velocity falls like cosh k(y + H) with the depth
step = case.read(0.3 * period)
places = np.column_stack([np.full(9, 0.5), np.linspace(0.05, 0.45, 9)])
u = step.sample(places, "U")[:, 0]
print("u(y)/u(0.45):   ", *(f"{value:.3f}" for value in u / u[-1]))
print("cosh k(y + H):  ", *(f"{value:.3f}" for value in np.cosh(k * places[:, 1]) / np.cosh(k * 0.45)))
