#pragma once
// Anderson's acceleration of a fixed-point iteration.

#include <Eigen/Dense>
#include <deque>
#include <vector>

namespace pfem {

/// x_{k+1} = x_k + f_k - sum_j gamma_j (dx_j + df_j) with the gamma that make |f_k - sum_j gamma_j df_j|
/// least, f_k being the change that the plain iteration would make and dx_j, df_j the differences of the last
/// `depth` iterations. With a linear iteration this is GMRES; depth 0 is the plain iteration. Where the
/// iteration ends is not changed.
class Anderson {
public:
    explicit Anderson(int depth) : depth_(depth) {}

    /// The next x from the current x and f.
    std::vector<double> next(const std::vector<double>& x, const std::vector<double>& f);

    /// Forget the past: the iteration itself has changed.
    void restart();

private:
    int depth_;
    Eigen::VectorXd x_, f_;  // of the last iteration
    std::deque<Eigen::VectorXd> dx_, df_;
};

}  // namespace pfem
