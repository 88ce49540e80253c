#include "mesher/space/shapes.hpp"

namespace pfem {

namespace {

double cross(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

/// Cuts off one ear after the other.
std::vector<Face<3>> polygonTriangles(const Points<2>& polygon) {
    std::vector<int> left;
    for (std::size_t k = 0; k < polygon.size(); ++k) left.push_back(static_cast<int>(k));
    std::vector<Face<3>> faces;
    const auto isEar = [&](std::size_t k) {
        const std::size_t n = left.size();
        const int a = left[(k + n - 1) % n], b = left[k], c = left[(k + 1) % n];
        if (!(cross(polygon[a], polygon[b], polygon[c]) > 0)) return false;
        for (const int i : left) {
            if (i == a || i == b || i == c) continue;
            const auto& x = polygon[i];
            if (cross(polygon[a], polygon[b], x) >= 0 && cross(polygon[b], polygon[c], x) >= 0 &&
                cross(polygon[c], polygon[a], x) >= 0)
                return false;
        }
        return true;
    };
    while (left.size() > 2) {
        std::size_t best = left.size();
        double largest = 0;
        for (std::size_t k = 0; k < left.size(); ++k) {  // the fattest ear first
            if (!isEar(k)) continue;
            const std::size_t n = left.size();
            const Vec<2>&a = polygon[left[(k + n - 1) % n]], &b = polygon[left[k]], &c = polygon[left[(k + 1) % n]];
            const double fat = cross(a, b, c) / ((a - b).squaredNorm() + (b - c).squaredNorm() + (c - a).squaredNorm());
            if (fat > largest) largest = fat, best = k;
        }
        if (best == left.size()) throw UserError("The polygon crosses itself or has doubled points");
        const std::size_t n = left.size();
        faces.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return faces;
}

}  // namespace pfem
