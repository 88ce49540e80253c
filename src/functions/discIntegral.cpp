#include "functions/discIntegral.hpp"

#include <algorithm>
#include <cmath>

#include "base/vectors.hpp"

namespace pfem {

namespace {

/// The triangle (0 a b): area a x b / 2, moment area (a + b)/3.
void addTriangle(const Vec<2>& a, const Vec<2>& b, AreaMoments& sum) {
    const double area = 0.5 * cross(a, b);
    sum.area += area;
    sum.moment += area / 3 * (a + b);
}

/// The sector between the directions of a and b, u and w as unit vectors: area R^2 angle/2, moment
/// R^3/3 (w_y - u_y, u_x - w_x).
void addSector(const Vec<2>& a, const Vec<2>& b, double R, AreaMoments& sum) {
    const double angle = std::atan2(cross(a, b), a.dot(b));
    if (angle == 0) return;
    const Vec<2> chord = b.normalized() - a.normalized();
    sum.area += 0.5 * R * R * angle;
    sum.moment += R * R * R / 3 * Vec<2>(chord[1], -chord[0]);
}

}  // namespace

AreaMoments discPart(const std::array<Vec<2>, 3>& corners, double R) {
    AreaMoments sum;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec<2>&a = corners[k], &b = corners[(k + 1) % 3], t = b - a;
        // |a + s t| = R at s = middle -+ half: the part of the edge that is in the disc
        const double length = t.squaredNorm();
        if (!(length > 0)) continue;
        const double middle = -a.dot(t) / length, squared = R * R / length - std::pow(cross(a, t) / length, 2);
        const double half = std::sqrt(std::max(0.0, squared));
        const double from = std::clamp(middle - half, 0.0, 1.0), to = std::clamp(middle + half, 0.0, 1.0);
        if (!(from < to)) {
            addSector(a, b, R, sum);
            continue;
        }
        const Vec<2> p = a + from * t, q = a + to * t;
        if (from > 0) addSector(a, p, R, sum);
        addTriangle(p, q, sum);
        if (to < 1) addSector(q, b, R, sum);
    }
    return sum;
}

}  // namespace pfem
