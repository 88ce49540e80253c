#pragma once
// Newtonian stress of the fluid's patches (35).

#include "integration/nodalPatches.hpp"
#include "state/problem.hpp"

namespace pfem {

/// Element stress equivalent to the nodal patches' sigma_I = 2 mu (d_I - tr(d_I)/3 I) - p_I I.
template <int Dim>
std::vector<Tensor<Dim>> fluidStress(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                     const Patches<Dim>& patches, const Points<Dim>& v,
                                     const std::vector<double>& p);

/// The same without pressure plus `bulk` * tr(d_I) I per node: the operator of the momentum matrix (42)-(43).
template <int Dim>
std::vector<Tensor<Dim>> fluidTangentStress(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                            const Patches<Dim>& patches, const Points<Dim>& dv,
                                            const std::vector<double>& bulk);

}  // namespace pfem
