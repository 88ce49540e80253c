#pragma once
// Which solver a sparse symmetric matrix is given.

#include <memory>
#include <vector>

#include "linear/nestedDissection.hpp"
#include "linear/symmetricSolver.hpp"

namespace pfem {

/// In which a factor is kept. It is computed in double precision, unless single is enough throughout.
enum class Precision { singleThroughout, single, twofold };

/// Part of each unknown: slabs of equal numbers, across the axis along which the fewest of those that meet are parted.
/// Those between the slabs are of none: where they are many the lower slabs get as many more.
template <int Dim>
std::vector<int> equalSlabs(const SymmetricMatrix& A, const Places<Dim>& place, int nParts);

/// A factor by dense fronts, of as many parts as pay; `place`: where each unknown of A is.
template <int Dim>
std::unique_ptr<SymmetricSolver> dissectedSolver(const SymmetricMatrix& A, Places<Dim> place, Precision precision);

/// The same for the velocities of solids: in double precision for large matrices of the plane, for small ones a
/// simplicial factor (CHOLMOD); in single precision for tetrahedra, where solutions wait for the many entries of the
/// factor, and throughout where their inertia is not small beside the stiffness. It shapes the iteration alone.
/// `stiffness`: the largest ratio of an entry of the diagonal to its inertia.
template <int Dim>
std::unique_ptr<SymmetricSolver> elasticSolver(const SymmetricMatrix& A, Places<Dim> place, double stiffness);

}  // namespace pfem
