#pragma once
// Which entries the momentum matrix of the solids has.

#include "integration/pointRows.hpp"
#include "momentum/solidMatrix.hpp"

namespace pfem {

/// Zeros where nodes share a stress point (nodal domains: two rings of the mesh). The columns of one node have the same
/// rows below its own.
template <int Dim>
SymmetricMatrix solidPattern(const PointRows<Dim>& rows, const SolidDofs<Dim>& dofs);

}  // namespace pfem
