#include "mesher/space/boxTree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/distance.hpp"
#include "state/placeSizes.hpp"

namespace pfem {

namespace {

/// Parameter at which the segment meets the triangle's plane within the triangle (to 1e-10), or a negative number.
double meetingPoint(const Vec<3>& a, const Vec<3>& b, const BoxTree::Triangle& t) {
    const Vec<3> u = t[1] - t[0], w = t[2] - t[0], n = u.cross(w);
    const double area = n.squaredNorm(), da = n.dot(a - t[0]), db = n.dot(b - t[0]);
    if (!(area > 0) || da == db || (da > 0 && db > 0) || (da < 0 && db < 0)) return -1;
    const double s = da / (da - db);
    const Vec<3> d = a + s * (b - a) - t[0];
    const double second = d.cross(w).dot(n) / area, third = u.cross(d).dot(n) / area;
    constexpr double slack = 1e-10;
    return second >= -slack && third >= -slack && second + third <= 1 + slack ? s : -1;
}

bool meetsBox(const Vec<3>& a, const Vec<3>& d, const Vec<3>& low, const Vec<3>& high) {
    double from = 0, to = 1;
    for (int k = 0; k < 3; ++k) {
        if (d[k] == 0) {
            if (a[k] < low[k] || a[k] > high[k]) return false;
            continue;
        }
        const double s = (low[k] - a[k]) / d[k], t = (high[k] - a[k]) / d[k];
        from = std::max(from, std::min(s, t) - 1e-12);
        to = std::min(to, std::max(s, t) + 1e-12);
    }
    return from <= to;
}

}  // namespace

BoxTree::BoxTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)), order_(triangles_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

int BoxTree::build(int first, int last) {
    Node node{triangles_[order_[first]][0], triangles_[order_[first]][0], first, last};
    for (int k = first; k < last; ++k)
        for (const auto& x : triangles_[order_[k]]) {
            node.low = node.low.cwiseMin(x).eval();
            node.high = node.high.cwiseMax(x).eval();
        }
    const int self = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    if (last - first <= 4) return self;
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const int middle = (first + last) / 2;
    const auto centre = [&](int k) { return triangles_[k][0][axis] + triangles_[k][1][axis] + triangles_[k][2][axis]; };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int i, int j) { return std::pair(centre(i), i) < std::pair(centre(j), j); });
    const int left = build(first, middle), right = build(middle, last);
    nodes_[self].left = left;
    nodes_[self].right = right;
    return self;
}

void BoxTree::forEachMet(const Vec<3>& a, const Vec<3>& b, const std::function<void(int, double)>& f) const {
    if (nodes_.empty()) return;
    const Vec<3> d = b - a;
    std::array<int, 64> stack{};
    int n = 1;
    while (n > 0) {
        const Node& node = nodes_[stack[--n]];
        if (!meetsBox(a, d, node.low, node.high)) continue;
        if (node.left >= 0) {
            stack[n++] = node.left;
            stack[n++] = node.right;
            continue;
        }
        for (int k = node.first; k < node.last; ++k)
            if (const double t = meetingPoint(a, b, triangles_[order_[k]]); t >= 0) f(order_[k], t);
    }
}

void BoxTree::forEachIn(const Vec<3>& low, const Vec<3>& high, const std::function<void(int)>& f) const {
    if (nodes_.empty()) return;
    std::array<int, 64> stack{};
    int n = 1;
    while (n > 0) {
        const Node& node = nodes_[stack[--n]];
        if ((node.low - high).maxCoeff() > 0 || (low - node.high).maxCoeff() > 0) continue;
        if (node.left >= 0) {
            stack[n++] = node.left;
            stack[n++] = node.right;
            continue;
        }
        for (int k = node.first; k < node.last; ++k) {
            const auto& [p, q, r] = triangles_[order_[k]];
            if ((p.cwiseMin(q).cwiseMin(r) - high).maxCoeff() <= 0 && (low - p.cwiseMax(q).cwiseMax(r)).maxCoeff() <= 0)
                f(order_[k]);
        }
    }
}

std::pair<double, int> BoxTree::nearest(const Vec<3>& x, double most) const {
    std::pair<double, int> best{most, -1};
    if (nodes_.empty()) return best;
    std::array<int, 64> stack{};
    int n = 1;
    while (n > 0) {
        const Node& node = nodes_[stack[--n]];
        if (distanceToBox<3>(x, node.low, node.high) >= best.first) continue;
        if (node.left >= 0) {
            const Node &l = nodes_[node.left], &r = nodes_[node.right];
            const bool leftFirst = distanceToBox<3>(x, l.low, l.high) < distanceToBox<3>(x, r.low, r.high);
            stack[n++] = leftFirst ? node.right : node.left;
            stack[n++] = leftFirst ? node.left : node.right;
            continue;
        }
        for (int k = node.first; k < node.last; ++k) {
            const auto& t = triangles_[order_[k]];
            const double distance = distanceToFace<3>({t[0], t[1], t[2]}, {0, 1, 2}, x);
            if (distance < best.first) best = {distance, order_[k]};
        }
    }
    return best;
}

}  // namespace pfem
