#include "functions/planeCut.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pfem {

namespace {

/// Where the edge i-j crosses the plane, d: distances of the nodes; the same bits for i-j and j-i.
EdgePoint crossing(int i, int j, const std::vector<double>& d) {
    const int a = std::min(i, j), b = std::max(i, j);
    if (d[a] == 0) return {a, a, 0};
    if (d[b] == 0) return {b, b, 0};
    return {a, b, d[a] / (d[a] - d[b])};
}

bool same(const EdgePoint& p, const EdgePoint& q) { return p.a == q.a && p.b == q.b; }

/// The points in a circle about the normal, without those that are twice there.
template <int Dim>
CutPiece pieceOf(const Points<Dim>& x, const Vec<Dim>& normal, std::vector<EdgePoint> points) {
    CutPiece piece;
    if constexpr (Dim == 3) {
        const Vec<3> a = valueAt(points[0], x), b = valueAt(points[1], x), c = valueAt(points[2], x);
        const Vec<3> d = valueAt(points.back(), x);
        if ((b - a).cross(c - a).dot(normal) + (c - a).cross(d - a).dot(normal) < 0)
            std::reverse(points.begin(), points.end());
    }
    for (const auto& point : points) {
        const bool there = std::any_of(piece.points.begin(), piece.points.begin() + piece.n,
                                       [&](const auto& p) { return same(p, point); });
        if (!there) piece.points[static_cast<std::size_t>(piece.n++)] = point;
    }
    return piece;
}

}  // namespace

template <int Dim>
std::vector<CutPiece> cutByPlane(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells,
                                 const Plane<Dim>& plane) {
    std::vector<double> d;
    double farthest = 0;
    for (const auto& place : x) {
        d.push_back((place - plane.point).dot(plane.normal));
        farthest = std::max(farthest, std::abs(d.back()));
    }
    for (double& distance : d)
        if (std::abs(distance) <= 1e-13 * farthest) distance = 0;
    std::vector<CutPiece> pieces;
    for (std::size_t e = 0; e < cells.size(); ++e) {
        std::vector<int> front, behind;  // what lies in the plane counts as in front
        for (const int node : cells[e]) (d[node] < 0 ? behind : front).push_back(node);
        if (front.empty() || behind.empty()) continue;
        std::vector<EdgePoint> points;
        for (std::size_t i = 0; i < front.size(); ++i)  // of two and two in a circle: ac ad bd bc
            for (std::size_t j = 0; j < behind.size(); ++j)
                points.push_back(crossing(front[i], behind[i % 2 == 0 ? j : behind.size() - 1 - j], d));
        CutPiece piece = pieceOf<Dim>(x, plane.normal, points);
        if (piece.n < Dim) continue;
        piece.cell = static_cast<int>(e);
        pieces.push_back(piece);
    }
    return pieces;
}

template <int Dim>
double integralOver(const CutPiece& piece, const Points<Dim>& x, const std::vector<double>& f) {
    const auto place = [&](int k) { return valueAt(piece.points[static_cast<std::size_t>(k)], x); };
    const auto value = [&](int k) { return valueAt(piece.points[static_cast<std::size_t>(k)], f); };
    if constexpr (Dim == 2) {
        return (place(1) - place(0)).norm() * 0.5 * (value(0) + value(1));
    } else {
        double sum = 0;
        for (int k = 1; k + 1 < piece.n; ++k)
            sum += 0.5 * (place(k) - place(0)).cross(place(k + 1) - place(0)).norm() *
                   (value(0) + value(k) + value(k + 1)) / 3;
        return sum;
    }
}

#define PFEM_INSTANTIATE(D)                                                                                          \
    template std::vector<CutPiece> cutByPlane<D>(const Points<D>&, const std::vector<Simplex<D>>&, const Plane<D>&); \
    template double integralOver<D>(const CutPiece&, const Points<D>&, const std::vector<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
