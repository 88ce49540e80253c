#pragma once
// Motion of a section that floats in a tank, by linear potential theory: what a float's swinging is compared with.

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <vector>

#include "base/types.hpp"

namespace pfem::test {

/// Boundary elements of constant strength along the section at rest, the surface and the tank's walls:
///     phi/2 = int (phi dG/dn - G dphi/dn),  G = ln r/(2 pi),  n out of the water.
/// On the surface phi is known, elsewhere dphi/dn; phi_t = - g eta, eta_t = dphi/dn there. M v + rho int phi N is the
/// momentum that stiffness changes, N = (n_x, n_y, (r - centre) x n): sway, heave, roll.
class FloatTheory {
public:
    using Motion = Eigen::Vector3d;

    /// `section`: points of the wetted contour at rest from its left water line (y = 0) to the right one. `size`: of
    /// the elements at the water line, growing by `growth` from one to the next.
    FloatTheory(const Points<2>& section, double halfWidth, double depth, double size, double growth = 1.03) {
        const auto right = spaced(section.back()[0], halfWidth, size, growth);
        const auto down = spaced(0, depth, size, growth);
        const double left = section.front()[0];
        Points<2> bottom, wallUp, surfaceRight, body(section.rbegin(), section.rend()), surfaceLeft, wallDown;
        const int n = std::max(20, static_cast<int>(4 * halfWidth / depth));
        for (int k = 0; k <= n; ++k) bottom.emplace_back(halfWidth * (2.0 * k / n - 1), -depth);
        for (const double y : std::vector(down.rbegin(), down.rend())) wallUp.emplace_back(halfWidth, -y);
        for (const double x : std::vector(right.rbegin(), right.rend())) surfaceRight.emplace_back(x, 0);
        for (const double x : spaced(-left, halfWidth, size, growth)) surfaceLeft.emplace_back(-x, 0);
        for (const double y : down) wallDown.emplace_back(-halfWidth, -y);
        nPiston_ = static_cast<int>(wallDown.size()) - 1;
        add(surfaceRight);
        add(surfaceLeft);
        nSurface_ = static_cast<int>(a_.size());
        add(body);
        nBody_ = static_cast<int>(a_.size()) - nSurface_;
        for (const auto* line : {&bottom, &wallUp, &wallDown}) add(*line);
        solve();
    }

    /// rho int N phi of unit velocities: the added mass where the surface does not move (high frequencies).
    Eigen::Matrix3d addedMass(const Vec<2>& centre, double rho) const {
        const auto N = directions(centre);
        return rho * weighted(N) * bodyOfVelocity_ * N;
    }

    /// Motions every dt after a release at rest from `start`; M, K: mass and stiffness about `centre`.
    std::vector<Motion> released(const Eigen::Matrix3d& M, const Eigen::Matrix3d& K, const Vec<2>& centre,
                                 const Motion& start, double dt, int steps) const {
        return path({M, K, directions(centre), [](double) { return 0.0; }}, start, dt, steps);
    }
    /// The same from rest, while the left wall moves to the right with the velocity `piston(t)`.
    std::vector<Motion> inWaves(const Eigen::Matrix3d& M, const Eigen::Matrix3d& K, const Vec<2>& centre,
                                const std::function<double(double)>& piston, double dt, int steps) const {
        return path({M, K, directions(centre), piston}, Motion::Zero(), dt, steps);
    }

private:
    static constexpr double density = 1000, gravity = 9.81;

    struct Float {
        Eigen::Matrix3d M, K;
        Eigen::MatrixXd N;
        std::function<double(double)> piston;
    };

    std::vector<Motion> path(const Float& body, const Motion& start, double dt, int steps) const {
        const Eigen::MatrixXd w = density * weighted(body.N), ofSurface = w * bodyOfSurface_,
                              rise = surfaceOfVelocity_ * body.N;
        const Eigen::Matrix3d inverse = (body.M + w * bodyOfVelocity_ * body.N).inverse();
        const Motion ofPiston = w * bodyOfPiston_;
        const int n = nSurface_;
        const auto rate = [&](double t, const Eigen::VectorXd& z) {  // phi, eta of the surface; momentum, place
            const double q = -body.piston(t);                        // dphi/dn, out of the water
            Eigen::VectorXd r(z.size());
            const Motion v = inverse * (z.segment<3>(2 * n) - ofSurface * z.head(n) - q * ofPiston);
            r << -gravity * z.segment(n, n), surfaceOfSurface_ * z.head(n) + rise * v + q * surfaceOfPiston_,
                -body.K * z.tail<3>(), v;
            return r;
        };
        Eigen::VectorXd z = Eigen::VectorXd::Zero(2 * n + 6);
        z.tail<3>() = start;
        std::vector<Motion> places{start};
        for (int k = 0; k < steps; ++k) {  // Runge and Kutta
            const double t = k * dt;
            const Eigen::VectorXd k1 = rate(t, z), k2 = rate(t + dt / 2, z + dt / 2 * k1),
                                  k3 = rate(t + dt / 2, z + dt / 2 * k2), k4 = rate(t + dt, z + dt * k3);
            z += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            places.emplace_back(z.tail<3>());
        }
        return places;
    }
    /// From x0 to x1 in pieces that begin with about `size` and grow.
    static std::vector<double> spaced(double x0, double x1, double size, double growth) {
        std::vector<double> x{0};
        for (double step = size; x.back() < x1 - x0; step *= growth) x.push_back(x.back() + step);
        const double scale = (x1 - x0) / x.back();
        for (double& one : x) one = x0 + scale * one;
        return x;
    }
    void add(const Points<2>& line) {
        for (std::size_t k = 1; k < line.size(); ++k) {
            a_.push_back(line[k - 1]);
            b_.push_back(line[k]);
        }
    }
    /// int G and int dG/dn over element j, at the middle of element i.
    std::pair<double, double> integrals(std::size_t i, std::size_t j) const {
        const Vec<2> t = (b_[j] - a_[j]).normalized(), d = 0.5 * (a_[i] + b_[i]) - a_[j];
        const double L = (b_[j] - a_[j]).norm(), s = d.dot(t), y = t[1] * d[0] - t[0] * d[1];
        const bool onLine = std::abs(y) < 1e-12 * L;
        const double angle = onLine ? 0 : std::atan((L - s) / y) + std::atan(s / y);
        const auto part = [&](double along) { return along * std::log(std::hypot(along, y)); };
        return {(part(L - s) + part(s) - L + y * angle) / (2 * M_PI), i == j ? 0 : -angle / (2 * M_PI)};
    }
    void solve() {
        const auto n = static_cast<Eigen::Index>(a_.size());
        Eigen::MatrixXd S(n, n), H(n, n);  // H phi = S dphi/dn
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j)
                std::tie(S(i, j), H(i, j)) = integrals(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        H.diagonal().array() -= 0.5;
        Eigen::MatrixXd A(n, n), right(n, nSurface_ + nBody_ + 1);
        A << S.leftCols(nSurface_), -H.rightCols(n - nSurface_);
        right << H.leftCols(nSurface_), -S.middleCols(nSurface_, nBody_), -S.rightCols(nPiston_).rowwise().sum();
        const Eigen::MatrixXd all = A.partialPivLu().solve(right);
        surfaceOfSurface_ = all.topLeftCorner(nSurface_, nSurface_);
        surfaceOfVelocity_ = all.block(0, nSurface_, nSurface_, nBody_);
        surfaceOfPiston_ = all.col(nSurface_ + nBody_).head(nSurface_);
        bodyOfPiston_ = all.col(nSurface_ + nBody_).segment(nSurface_, nBody_);
        bodyOfSurface_ = all.block(nSurface_, 0, nBody_, nSurface_);
        bodyOfVelocity_ = all.block(nSurface_, nSurface_, nBody_, nBody_);
    }
    Eigen::MatrixXd directions(const Vec<2>& centre) const {
        Eigen::MatrixXd N(nBody_, 3);
        for (int k = 0; k < nBody_; ++k) {
            const Vec<2>&a = a_[nSurface_ + k], &b = b_[nSurface_ + k], r = 0.5 * (a + b) - centre;
            const Vec<2> n = Vec<2>(b[1] - a[1], a[0] - b[0]).normalized();
            N.row(k) << n[0], n[1], r[0] * n[1] - r[1] * n[0];
        }
        return N;
    }
    Eigen::MatrixXd weighted(const Eigen::MatrixXd& N) const {
        Eigen::MatrixXd w = N.transpose();
        for (int k = 0; k < nBody_; ++k) w.col(k) *= (b_[nSurface_ + k] - a_[nSurface_ + k]).norm();
        return w;
    }

    Points<2> a_, b_;                             // ends of the elements, the water on their left
    int nSurface_ = 0, nBody_ = 0, nPiston_ = 0;  // elements; the piston's, along the left wall, are the last
    Eigen::MatrixXd surfaceOfSurface_, surfaceOfVelocity_, bodyOfSurface_, bodyOfVelocity_;
    Eigen::VectorXd surfaceOfPiston_, bodyOfPiston_;
};

}  // namespace pfem::test
