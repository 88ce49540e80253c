#pragma once
// Pressures by multigrid, velocities eliminated.

#include <memory>

#include "linear/multigrid.hpp"
#include "linear/symmetricSolver.hpp"

namespace pfem {

/// [K B; B^T -M] by conjugate gradients on S = K + B M^{-1} B^T. Elastic velocities have a factor of M inside S; the
/// levels are those of K + B diag(M)^{-1} B^T, which is S where M is diagonal.
class MultigridSolver : public SymmetricSolver {
public:
    /// `elastic`: a solver for M of the elastic velocities, if there are any. `rows` of the pressures.
    MultigridSolver(SaddleSizes sizes, std::unique_ptr<SymmetricSolver> elastic, double tolerance, RankRows rows);

    void analyse(const SymmetricMatrix& A) override;
    void factor(const SymmetricMatrix& A) override;
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;

private:
    Eigen::VectorXd inverseM(const Eigen::VectorXd& velocities) const;

    SaddleSizes sizes_;
    std::unique_ptr<SymmetricSolver> elastic_;
    Saddle saddle_;
    Multigrid multigrid_;
};

}  // namespace pfem
