#include "linear/multigrid.hpp"

#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

[[noreturn]] void fail(const char* why) {
    throw StepFailure(std::string("the linear iteration of the pressure does not converge: ") + why);
}

}  // namespace

void Multigrid::setUp(SparseRows A, Operator apply) {
    levels_.reset();  // its memory first
    levels_ = std::make_unique<Levels>(std::move(A), rows_);
    apply_ = std::move(apply);
}

/// Of numbers of own rows, over all.
double Multigrid::dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const double own = parallelSum(static_cast<int>(a.size()), [&](int i) { return a[i] * b[i]; });
    return rows_.ranks.isAlone() ? own : rows_.sum(Eigen::VectorXd::Constant(1, own))[0];
}

Eigen::VectorXd Multigrid::product(const Eigen::VectorXd& own) const {
    if (rows_.ranks.isAlone()) return apply_ ? apply_(own) : multiply(levels_->matrix(), own);
    const Eigen::VectorXd all = rows_.all(own);
    if (!apply_) return multiply(levels_->matrix(), all);
    return apply_(all).segment(rows_.begin(), own.size());
}

/// Hestenes and Stiefel, from x = 0.
Eigen::VectorXd Multigrid::solve(const Eigen::VectorXd& b) const {
    constexpr int mostIterations = 500;
    iterations_ = 0;
    if (b.isZero(0)) return Eigen::VectorXd::Zero(b.size());
    const int n = levels_->matrix().n();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n), r = b.segment(rows_.begin(), n);
    Eigen::VectorXd z = levels_->cycle(r), direction = z;
    double rz = dot(r, z);
    const double target = tolerance_ * std::sqrt(dot(z, z));
    for (; !(std::sqrt(dot(z, z)) <= target); ++iterations_) {
        if (iterations_ == mostIterations) fail("too many iterations");
        if (!(rz > 0)) fail("the preconditioner is not positive definite");
        const Eigen::VectorXd q = product(direction);
        const double curvature = dot(direction, q);
        if (!(curvature > 0)) fail("the matrix is not positive definite");
        const double step = rz / curvature;
        parallelFor(n, [&](int i) {
            x[i] += step * direction[i];
            r[i] -= step * q[i];
        });
        z = levels_->cycle(r);
        const double before = std::exchange(rz, dot(r, z)), beta = rz / before;
        parallelFor(n, [&](int i) { direction[i] = z[i] + beta * direction[i]; });
    }
    return rows_.all(x);
}

}  // namespace pfem
