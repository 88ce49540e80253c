#include "solver/anderson.hpp"

namespace pfem {

std::vector<double> Anderson::next(const std::vector<double>& x, const std::vector<double>& f) {
    const auto n = static_cast<Eigen::Index>(x.size());
    const Eigen::VectorXd xNow = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
    const Eigen::VectorXd fNow = Eigen::Map<const Eigen::VectorXd>(f.data(), n);
    if (depth_ > 0 && x_.size() == n) {
        dx_.emplace_back(xNow - x_);
        df_.emplace_back(fNow - f_);
        if (static_cast<int>(dx_.size()) > depth_) {
            dx_.pop_front();
            df_.pop_front();
        }
    }
    x_ = xNow;
    f_ = fNow;
    Eigen::VectorXd result = xNow + fNow;
    const auto m = static_cast<Eigen::Index>(df_.size());
    if (m > 0) {
        Eigen::MatrixXd normal(m, m);
        Eigen::VectorXd rhs(m);
        for (Eigen::Index i = 0; i < m; ++i) {
            rhs[i] = df_[i].dot(fNow);
            for (Eigen::Index j = 0; j <= i; ++j) normal(i, j) = normal(j, i) = df_[i].dot(df_[j]);
        }
        normal.diagonal() *= 1 + 1e-12;  // differences may be parallel up to round-off
        const Eigen::VectorXd gamma = normal.ldlt().solve(rhs);
        if (gamma.allFinite())
            for (Eigen::Index j = 0; j < m; ++j) result -= gamma[j] * (dx_[j] + df_[j]);
    }
    return {result.data(), result.data() + n};
}

void Anderson::restart() {
    x_.resize(0);
    f_.resize(0);
    dx_.clear();
    df_.clear();
}

}  // namespace pfem
