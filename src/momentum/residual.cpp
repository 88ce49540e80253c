#include "momentum/residual.hpp"

#include "base/parallel.hpp"

namespace pfem {

template <int Dim>
Points<Dim> tractionForce(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions, const Points<Dim>& x) {
    Points<Dim> force(x.size(), Vec<Dim>::Zero());
    for (std::size_t n = 0; n < mesh.patches.size(); ++n) {
        if (!conditions.type[n]->loads) continue;
        for (const auto& face : mesh.patches[n].faces)
            for (int node : face) force[node] += conditions.traction[n] * (faceArea<Dim>(x, face).norm() / Dim);
    }
    return force;
}

template <int Dim>
Points<Dim> momentumResidual(const std::vector<double>& mass, const Points<Dim>& a, const Vec<Dim>& gravity,
                             const Patches<Dim>& fluid, const std::vector<double>& p, const Patches<Dim>& solid,
                             const std::vector<Tensor<Dim>>& solidStress, const Points<Dim>& external) {
    Points<Dim> R(a.size());
    forEach(static_cast<int>(a.size()), [&](int i) { R[i] = mass[i] * (a[i] - gravity) - external[i]; });
    addPressureForce<Dim>(fluid, p, R);
    addInternalForce<Dim>(solid, solidStress, R);
    return R;
}

template Points<2> tractionForce<2>(const Mesh<2>&, const BoundaryConditions<2>&, const Points<2>&);
template Points<2> momentumResidual<2>(const std::vector<double>&, const Points<2>&, const Vec<2>&, const Patches<2>&,
                                       const std::vector<double>&, const Patches<2>&, const std::vector<Tensor<2>>&,
                                       const Points<2>&);

}  // namespace pfem
