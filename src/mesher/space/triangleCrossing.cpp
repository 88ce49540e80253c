#include <algorithm>
#include <cmath>

#include "mesh/distance.hpp"
#include "mesher/space/featureLines.hpp"

namespace pfem {

namespace {

/// Where the triangle's edges meet the plane n . x = d, at most two different points.
Points<3> cut(const BoxTree::Triangle& t, const Vec<3>& n, double d, double tolerance) {
    std::array<double, 3> s;
    for (int k = 0; k < 3; ++k) {
        s[k] = n.dot(t[k]) - d;
        if (std::abs(s[k]) < tolerance) s[k] = 0;
    }
    Points<3> points;
    const auto add = [&](const Vec<3>& x) {
        for (const auto& y : points)
            if ((x - y).norm() < tolerance) return;
        points.push_back(x);
    };
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3;
        if (s[k] == 0) add(t[k]);
        if (s[k] * s[l] < 0) add(t[k] + s[k] / (s[k] - s[l]) * (t[l] - t[k]));
    }
    return points;
}

bool onEdge(const BoxTree::Triangle& t, const Vec<3>& a, const Vec<3>& b, double tolerance) {
    for (int k = 0; k < 3; ++k)
        if (distanceToSegment<3>(t[k], t[(k + 1) % 3], a) < tolerance &&
            distanceToSegment<3>(t[k], t[(k + 1) % 3], b) < tolerance)
            return true;
    return false;
}

}  // namespace

std::optional<std::array<Vec<3>, 2>> crossingLine(const BoxTree::Triangle& a, const BoxTree::Triangle& b,
                                                  double tolerance) {
    const Vec<3> na = (a[1] - a[0]).cross(a[2] - a[0]).normalized(), nb = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
    const Points<3> onA = cut(a, nb, nb.dot(b[0]), tolerance), onB = cut(b, na, na.dot(a[0]), tolerance);
    if (onA.size() != 2 || onB.size() != 2) return {};
    const Vec<3> d = (onA[1] - onA[0]).normalized();
    const auto at = [&](const Vec<3>& x) { return d.dot(x - onA[0]); };
    const double low = std::max(0.0, std::min(at(onB[0]), at(onB[1]))),
                 high = std::min(at(onA[1]), std::max(at(onB[0]), at(onB[1])));
    if (high - low < tolerance) return {};
    // the ends are those of the edges, to the last bit
    const auto nearest = [&](double s) {
        Vec<3> best = onA[0];
        for (const auto* points : {&onA, &onB})
            for (const auto& x : *points)
                if (std::abs(at(x) - s) < std::abs(at(best) - s)) best = x;
        return best;
    };
    const Vec<3> p = nearest(low), q = nearest(high);
    if (onEdge(a, p, q, 2 * tolerance) && onEdge(b, p, q, 2 * tolerance)) return {};
    return std::array<Vec<3>, 2>{p, q};
}

}  // namespace pfem
