#pragma once
// Pressures by multigrid, velocities eliminated.

#include <memory>

#include "linear/multigrid.hpp"
#include "linear/symmetricSolver.hpp"

namespace pfem {

/// The inverse of M of elastic velocities by a factor of M/scale that is there already.
struct ElasticInverse {
    std::shared_ptr<const SymmetricSolver> factor;
    double scale = 1;

    Eigen::VectorXd operator()(const Eigen::VectorXd& f) const;
};

/// [K B; B^T -M] by conjugate gradients on S = K + B M^{-1} B^T. Elastic velocities have a factor of M inside S; the
/// levels are those of K + B diag(M)^{-1} B^T, which is S where M is diagonal. Of M the matrix needs its diagonal
/// alone.
class MultigridSolver : public SymmetricSolver {
public:
    /// `elastic`: for the elastic velocities, if there are any. `rows` of the pressures.
    MultigridSolver(SaddleSizes sizes, ElasticInverse elastic, double tolerance, RankRows rows);

    void analyse(const SymmetricMatrix& A) override;
    void factor(const SymmetricMatrix& A) override;
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;
    Eigen::VectorXd solveFirst(const Eigen::VectorXd& b, int n) const override;

private:
    Eigen::VectorXd inverseM(const Eigen::VectorXd& velocities) const;

    SaddleSizes sizes_;
    ElasticInverse elastic_;
    Saddle saddle_;
    RankRows rows_;
    Multigrid multigrid_;
};

}  // namespace pfem
