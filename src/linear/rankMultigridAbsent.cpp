// In a build without PETSc, which has no ranks.

#include "base/error.hpp"
#include "linear/rankMultigrid.hpp"

namespace pfem {

std::unique_ptr<IterativeSolver> rankMultigrid(double, RankRows) {
    throw InternalError("ranks in a build without MPI");
}

}  // namespace pfem
