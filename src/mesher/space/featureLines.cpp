#include "mesher/space/featureLines.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include "mesh/simplex.hpp"
#include "mesher/space/lineGraph.hpp"

namespace pfem {

std::vector<std::array<int, 2>> sharpEdges(const TriSurface& surface) {
    std::map<std::array<int, 2>, std::vector<int>> beside;
    for (int k = 0; k < surface.size(); ++k)
        for (int e = 0; e < 3; ++e) {
            const auto [low, high] = std::minmax(surface.triangles[k][e], surface.triangles[k][(e + 1) % 3]);
            beside[{low, high}].push_back(k);
        }
    std::vector<std::array<int, 2>> sharp;
    for (const auto& [edge, faces] : beside) {
        bool is = faces.size() != 2;
        if (!is) {
            const Vec<3> a = faceArea<3>(surface.x, surface.triangles[faces[0]]),
                         b = faceArea<3>(surface.x, surface.triangles[faces[1]]);
            is = surface.region[faces[0]] != surface.region[faces[1]] || a.dot(b) < sharpCosine * a.norm() * b.norm();
        }
        if (is) sharp.push_back(edge);
    }
    return sharp;
}

namespace {

/// Are there different labels around the middle of a piece?
bool isBetweenLabels(const SpaceDomain& domain, const Vec<3>& a, const Vec<3>& b, double size) {
    const Vec<3> middle = 0.5 * (a + b), d = (b - a).normalized(), u = d.unitOrthogonal(), w = d.cross(u);
    const double radius = std::min(1e-2 * size, 0.1 * (b - a).norm());
    constexpr int directions = 24;
    const auto labelAt = [&](int k) {
        const double angle = 2 * std::numbers::pi * (k + 0.37) / directions;
        return domain.label(middle + radius * (std::cos(angle) * u + std::sin(angle) * w));
    };
    const int first = labelAt(0);
    for (int k = 1; k < directions; ++k)
        if (labelAt(k) != first) return true;
    return false;
}

}  // namespace

std::vector<Points<3>> featureLines(const SpaceDomain& domain, double size) {
    const double tolerance = 1e-6 * size;
    LineGraph graph(tolerance);
    for (const auto& surface : domain.surfaces())
        for (const auto& [a, b] : sharpEdges(surface)) graph.add(surface.x[a], surface.x[b]);
    const BoxTree& tree = domain.tree();
    int k = 0;
    for (const auto& surface : domain.surfaces())
        for (int t = 0; t < surface.size(); ++t, ++k) {
            const auto& [p, q, r] = tree.triangle(k);
            tree.forEachIn(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r), [&](int other) {
                if (domain.surfaceOf(other) <= domain.surfaceOf(k)) return;
                if (const auto line = crossingLine(tree.triangle(k), tree.triangle(other), tolerance))
                    graph.add((*line)[0], (*line)[1]);
            });
        }
    graph.cut();
    graph.removeIf([&](const Vec<3>& a, const Vec<3>& b) { return !isBetweenLabels(domain, a, b, size); });
    return graph.lines(sharpCosine);
}

}  // namespace pfem
