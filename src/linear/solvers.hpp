#pragma once
// Which solver a sparse symmetric matrix is given.

#include <memory>

#include "linear/nestedDissection.hpp"
#include "linear/saddle.hpp"
#include "linear/symmetricSolver.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

enum class Precision { single, twofold };  // in which a factor is kept; it is computed in double precision

/// A factor by dense fronts, of as many parts as pay; `place`: where each unknown of A is.
template <int Dim>
std::unique_ptr<SymmetricSolver> dissectedSolver(const SymmetricMatrix& A, Places<Dim> place, Precision precision);

/// The same in double precision for large matrices and for tetrahedra, whose factors have many entries; for small ones
/// of the plane a simplicial factor (CHOLMOD).
template <int Dim>
std::unique_ptr<SymmetricSolver> elasticSolver(const SymmetricMatrix& A, Places<Dim> place);

/// The same as `dissectedSolver` for [K B; B^T -M], by multigrid for the pressures, whose rows `ranks` share; `place`
/// of all unknowns.
template <int Dim>
std::unique_ptr<SymmetricSolver> multigridSolver(const SymmetricMatrix& A, const Places<Dim>& place,
                                                 const SaddleSizes& sizes, double tolerance, const Ranks& ranks = {});

}  // namespace pfem
