#pragma once
// Which solver a sparse symmetric matrix is given.

#include <memory>

#include "linear/nestedDissection.hpp"
#include "linear/symmetricSolver.hpp"

namespace pfem {

enum class Precision { single, twofold };  // in which a factor is kept; it is computed in double precision

/// A factor by dense fronts, of as many parts as pay; `place`: where each unknown of A is.
template <int Dim>
std::unique_ptr<SymmetricSolver> dissectedSolver(const SymmetricMatrix& A, Places<Dim> place, Precision precision);

/// The same for the velocities of solids: in double precision for large matrices of the plane, for small ones a
/// simplicial factor (CHOLMOD); in single precision for tetrahedra, where solutions wait for the many entries of the
/// factor. It shapes the iteration alone.
template <int Dim>
std::unique_ptr<SymmetricSolver> elasticSolver(const SymmetricMatrix& A, Places<Dim> place);

}  // namespace pfem
