#include "remesh/enclosingBall.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pfem {

/// Centre x_0 + N/D with N = |a|^2 b x c + |b|^2 c x a + |c|^2 a x b, D = 2 a . (b x c), of the edges a, b, c from
/// x_0. Counting operations, N is wrong by less than 50 u L^4 and D by 80 u L^3; L: longest of the edges, u: round-off.
std::optional<Ball> enclosingBall(const Points<3>& x, const Simplex<3>& cell) {
    constexpr double u = std::numeric_limits<double>::epsilon(), bound = 128 * u;
    const Vec<3>& first = x[cell[0]];
    const Vec<3> a = x[cell[1]] - first, b = x[cell[2]] - first, c = x[cell[3]] - first;
    const double L2 = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}), L3 = L2 * std::sqrt(L2);
    const Vec<3> bc = b.cross(c);
    const double D = 2 * a.dot(bc), certain = D - bound * L3;
    if (!(certain > 0)) return std::nullopt;
    const Vec<3> toCentre = (a.squaredNorm() * bc + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)) / D;
    const double radius = toCentre.norm();
    const double error = bound * (L2 * L2 + radius * L3) / certain;
    const double least = radius + 4 * error, scale = first.cwiseAbs().maxCoeff() + radius;
    return Ball{first + toCentre, least + 16 * u * scale};
}

}  // namespace pfem
