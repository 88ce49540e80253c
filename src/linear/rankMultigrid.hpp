#pragma once
// The same by many ranks: PETSc's smoothed aggregation.

#include "linear/multigrid.hpp"
#include "linear/rankRows.hpp"

namespace pfem {

/// `rows`: which ranks have which; all have all of b and x. `tolerance` as of Multigrid. Needs MPI and with it PETSc
/// (CMake's PFEM_PETSC).
std::unique_ptr<IterativeSolver> rankMultigrid(double tolerance, RankRows rows);

}  // namespace pfem
