# The results of this study as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import pathlib

import numpy as np
import pfem

plt = pfem.pyplot()

# %% first maximum of the tip's displacement: the parabola through the three highest values of each run
for folder in sorted(f for f in pathlib.Path("study").iterdir() if f.is_dir()):
    case = pfem.Case(folder)
    tip = case.table("tip", "D")
    uy = tip.values[:, 0, 1]
    k = min(max(int(uy.argmax()), 1), len(uy) - 2)
    c = np.polyfit(tip.time[k - 1:k + 2] - tip.time[k], uy[k - 1:k + 2], 2)
    peak = c[2] - c[1] ** 2 / (4 * c[0]) if c[0] < 0 else uy[k]
    print(f"{folder.name:20s} first maximum {peak:.4f}")
    if plt:
        plt.plot(tip.time, uy, label=folder.name)

# %%
if plt:
    plt.legend()
    plt.savefig("notebook_tip.png")
    plt.close()

# %% bending stress at the support over the height, at the last time
solid = case.read("latest").solid
support = np.flatnonzero(solid.point["X"][:, 0] < 1e-9)
support = support[np.argsort(solid.point["X"][support, 1])]
for i in support:
    print(f"y = {solid.point['X'][i, 1]:5.2f}   sigma_xx = {solid.point['sigma'][i, 0]:9.3f}")
