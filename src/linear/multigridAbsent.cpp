// In a build without PETSc.

#include "base/error.hpp"
#include "linear/multigrid.hpp"

namespace pfem {

struct Multigrid::Petsc {};

bool hasMultigrid() { return false; }

Multigrid::Multigrid(double, RankRows) {
    throw UserError("This build has no multigrid (CMake's PFEM_PETSC): write 'solver direct;' or 'solver auto;'.");
}
Multigrid::~Multigrid() = default;
void Multigrid::setUp(SparseRows, Operator) {}
Eigen::VectorXd Multigrid::solve(const Eigen::VectorXd& b) const { return b; }
int Multigrid::iterations() const { return 0; }

}  // namespace pfem
