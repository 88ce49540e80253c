#pragma once
// Where two straight lines between points cross.

#include <optional>

#include "base/types.hpp"

namespace pfem {

/// Twice the area of the triangle a b c, negative when it runs clockwise [m2].
inline double turn(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The point in which the segments a b and c d cross, if they do. Of segments on one line the signs are round-off: then
/// the point lies beside one of them.
inline std::optional<Vec<2>> crossingOf(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
    const double atC = turn(a, b, c), atD = turn(a, b, d);
    if ((atC > 0) == (atD > 0) || (turn(c, d, a) > 0) == (turn(c, d, b) > 0)) return {};
    const Vec<2> x = c + atC / (atC - atD) * (d - c);
    const double s = (x - a).dot(b - a) / (b - a).squaredNorm();
    if (s < -1e-9 || s > 1 + 1e-9) return {};
    return x;
}

}  // namespace pfem
