#include "linear/multigridSolver.hpp"

namespace pfem {

Eigen::VectorXd ElasticInverse::operator()(const Eigen::VectorXd& f) const {
    if (f.isZero(0)) return f;
    return factor->solve(f) / scale;
}

MultigridSolver::MultigridSolver(SaddleSizes sizes, ElasticInverse elastic, double tolerance, RankRows rows)
    : sizes_(sizes), elastic_(std::move(elastic)), rows_(std::move(rows)), multigrid_(tolerance, rows_) {}

void MultigridSolver::analyse(const SymmetricMatrix&) {}

void MultigridSolver::factor(const SymmetricMatrix& A) {
    saddle_ = split(A, sizes_);
    Multigrid::Operator apply;
    if (sizes_.nElastic > 0)
        apply = [this](const Eigen::VectorXd& p) -> Eigen::VectorXd {
            return multiply(saddle_.K, p) + multiply(saddle_.B, inverseM(multiply(saddle_.Bt, p)));
        };
    SparseRows S = eliminateDiagonal(saddle_, rows_.begin(), rows_.end(sizes_.nPressures));
    if (!apply) saddle_.K = {};  // nobody asks for it any more
    multigrid_.setUp(std::move(S), std::move(apply));
}

Eigen::VectorXd MultigridSolver::inverseM(const Eigen::VectorXd& velocities) const {
    const int nElastic = sizes_.nElastic;
    Eigen::VectorXd x = velocities.cwiseProduct(
        Eigen::Map<const Eigen::VectorXd>(saddle_.inverse.data(), static_cast<Eigen::Index>(saddle_.inverse.size())));
    if (nElastic > 0) x.head(nElastic) = elastic_(velocities.head(nElastic));
    return x;
}

Eigen::VectorXd MultigridSolver::solve(const Eigen::VectorXd& b) const {
    const int nP = sizes_.nPressures;
    const Eigen::VectorXd given = b.tail(b.size() - nP);
    Eigen::VectorXd x(b.size());
    x.head(nP) = multigrid_.solve(b.head(nP) + multiply(saddle_.B, inverseM(given)));
    x.tail(b.size() - nP) = inverseM(multiply(saddle_.Bt, x.head(nP)) - given);
    return x;
}

Eigen::VectorXd MultigridSolver::solveFirst(const Eigen::VectorXd& b, int n) const {
    return b.size() == sizes_.nPressures ? multigrid_.solve(b) : SymmetricSolver::solveFirst(b, n);
}

}  // namespace pfem
