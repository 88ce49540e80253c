#include "mesher/space/insideTest.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int turn(const Vec<3>& a, const Vec<3>& b, const Vec<3>& q) {
    const auto sign =
        CGAL::orientation(Kernel::Point_2(a[0], a[1]), Kernel::Point_2(b[0], b[1]), Kernel::Point_2(q[0], q[1]));
    if (sign != CGAL::COLLINEAR) return sign == CGAL::LEFT_TURN ? 1 : -1;
    // q moved by (e, e^2): the derivative of (b - a) x (q - a)
    if (a[1] != b[1]) return a[1] > b[1] ? 1 : -1;
    return a[0] < b[0] ? 1 : a[0] > b[0] ? -1 : 0;
}

double columnWidth(const TriSurface& surface) {
    const Vec<3> extent = surface.high() - surface.low();
    return std::sqrt(std::max(extent[0] * extent[1], 1e-12 * extent.squaredNorm()) / std::max(1, surface.size())) * 2;
}

}  // namespace

InsideTest::InsideTest(const TriSurface& surface)
    : surface_(surface),
      low_(surface.low()),
      high_(surface.high()),
      columns_(low_.head<2>(), high_.head<2>(), columnWidth(surface)),
      seen_(surface.triangles.size(), 0) {
    for (int k = 0; k < surface_.size(); ++k) {
        const auto& [a, b, c] = surface_.triangles[k];
        const auto &p = surface_.x[a], &q = surface_.x[b], &r = surface_.x[c];
        columns_.add(k, p.cwiseMin(q).cwiseMin(r).head<2>(), p.cwiseMax(q).cwiseMax(r).head<2>());
    }
}

/// Is x, moved as said, below the triangle?
bool InsideTest::above(int triangle, const Vec<3>& x) const {
    const auto& t = surface_.triangles[triangle];
    const Vec<3>&a = surface_.x[t[0]], &b = surface_.x[t[1]], &c = surface_.x[t[2]];
    const int first = turn(a, b, x);
    if (first == 0 || turn(b, c, x) != first || turn(c, a, x) != first) return false;
    const auto at = [](const Vec<3>& v) { return Kernel::Point_3(v[0], v[1], v[2]); };
    const auto side = CGAL::orientation(at(a), at(b), at(c), at(x));  // positive: where the right-hand normal points
    int sign = side == CGAL::POSITIVE ? 1 : side == CGAL::NEGATIVE ? -1 : 0;
    if (sign == 0) {
        const Vec<3> n = (b - a).cross(c - a);
        const double lead = n[0] != 0 ? n[0] : n[1] != 0 ? n[1] : n[2];
        sign = lead > 0 ? 1 : -1;
    }
    return sign != first;  // turning to the left seen from above: the normal points up
}

bool InsideTest::operator()(const Vec<3>& x) const {
    for (int d = 0; d < 3; ++d)
        if (x[d] < low_[d] || x[d] > high_[d]) return false;
    ++question_;
    bool inside = false;
    columns_.forEachNear(x.head<2>(), 0, [&](int k) {
        if (seen_[k] == question_) return;
        seen_[k] = question_;
        if (above(k, x)) inside = !inside;
    });
    return inside;
}

}  // namespace pfem
