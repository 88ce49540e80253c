# The results of this case as numpy arrays; cells begin with "# %%". In the case, after a run:
#
#     . <libpfem>/etc/bashrc && python3 notebook.py

# %%
import pfem

case = pfem.Case()
plt = pfem.pyplot()

# %% the bottom and the reaction of the container's ends
bottom = case.table("bottom", "D")
reaction = case.table("supports", "reaction.dat")
uy = bottom.values[:, 0, 1]
print(f"lowest point of the bottom: u_y = {uy.min():.3f} m at {bottom.time[uy.argmin()]:.2f} s, at the end {uy[-1]:.3f} m")
print("columns of reaction.dat:", *reaction.columns)

# %% stress in the container at the last time
solid = case.read("latest").solid
stress = pfem.vonMises(solid.point["sigma"])
at = stress.argmax()
print(f"largest von Mises stress at {solid.time:g} s: {stress[at]:.0f} Pa at ({solid.points[at, 0]:.2f} {solid.points[at, 1]:.2f})")
if plt:
    plt.colorbar(pfem.triangles(plt, solid, stress), label="von Mises stress [Pa]")
    plt.savefig("notebook_stress.png", dpi=150)
    plt.close()
