#include "picture/cut.hpp"

namespace pfem {

namespace {

/// Where the plane crosses the edge from a point that is left to one that is not.
Corner3 crossing(const CuttingPlane& plane, const Corner3& left, const Corner3& gone) {
    const double a = plane.beyond(left.x), t = a / (a - plane.beyond(gone.x));
    return {left.x + t * (gone.x - left.x), left.normal + t * (gone.normal - left.normal),
            left.value + t * (gone.value - left.value)};
}

}  // namespace

Corners3 partLeft(const CuttingPlane& plane, const Corners3& polygon) {
    Corners3 result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const bool left = plane.beyond(a.x) < 0, nextLeft = plane.beyond(b.x) < 0;
        if (left) result.push_back(a);
        if (left != nextLeft) result.push_back(left ? crossing(plane, a, b) : crossing(plane, b, a));
    }
    return result;
}

Corners3 section(const CuttingPlane& plane, const std::array<Corner3, 4>& corners) {
    std::vector<const Corner3*> left, gone;
    for (const Corner3& corner : corners) (plane.beyond(corner.x) < 0 ? left : gone).push_back(&corner);
    Corners3 result;
    for (const Corner3* a : left)
        for (const Corner3* b : gone) result.push_back(crossing(plane, *a, *b));
    if (result.size() == 4) std::swap(result[2], result[3]);  // round the quadrangle
    for (Corner3& corner : result) corner.normal = plane.normal;
    return result;
}

std::optional<std::array<Vec<3>, 2>> trace(const CuttingPlane& plane, const std::array<Vec<3>, 3>& triangle) {
    std::vector<Vec<3>> points;
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner3 a{triangle[i]}, b{triangle[(i + 1) % 3]};
        const bool left = plane.beyond(a.x) < 0;
        if (left != (plane.beyond(b.x) < 0)) points.push_back((left ? crossing(plane, a, b) : crossing(plane, b, a)).x);
    }
    if (points.size() != 2) return std::nullopt;
    return std::array<Vec<3>, 2>{points[0], points[1]};
}

std::optional<std::array<Vec<3>, 2>> partLeft(const CuttingPlane& plane, const std::array<Vec<3>, 2>& line) {
    const Corners3 part = partLeft(plane, Corners3{{line[0]}, {line[1]}});
    if (part.size() < 2) return std::nullopt;
    return std::array<Vec<3>, 2>{part[0].x, part[1].x};
}

}  // namespace pfem
