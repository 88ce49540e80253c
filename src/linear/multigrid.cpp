#include "linear/multigrid.hpp"

#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return parallelSum(static_cast<int>(a.size()), [&](int i) { return a[i] * b[i]; });
}

[[noreturn]] void fail(const char* why) {
    throw StepFailure(std::string("the linear iteration of the pressure does not converge: ") + why);
}

}  // namespace

void Multigrid::setUp(SparseRows A, Operator apply) {
    levels_.reset();  // its memory first
    levels_ = std::make_unique<Levels>(std::move(A));
    apply_ = std::move(apply);
}

/// Hestenes and Stiefel, from x = 0.
Eigen::VectorXd Multigrid::solve(const Eigen::VectorXd& b) const {
    constexpr int mostIterations = 500;
    const int n = static_cast<int>(b.size());
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    iterations_ = 0;
    if (b.isZero(0)) return x;
    Eigen::VectorXd r = b, z = levels_->cycle(r), direction = z;
    double rz = dot(r, z);
    const double target = tolerance_ * std::sqrt(dot(z, z));
    for (; !(std::sqrt(dot(z, z)) <= target); ++iterations_) {
        if (iterations_ == mostIterations) fail("too many iterations");
        if (!(rz > 0)) fail("the preconditioner is not positive definite");
        const Eigen::VectorXd q = apply_ ? apply_(direction) : multiply(levels_->matrix(), direction);
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
    return x;
}

}  // namespace pfem
