#include "mesh/standing.hpp"

#include <algorithm>

namespace pfem {

namespace {

/// Is the point within `tolerance` of the line between a and b?
bool liesOn(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b, double tolerance) {
    const Vec<2> t = b - a;
    const double s = std::clamp((p - a).dot(t) / t.squaredNorm(), 0.0, 1.0);
    return (p - a - s * t).norm() < tolerance;
}

}  // namespace

void standOnWalls(const Mesh<2>& mesh, const std::vector<bool>& isWall, Nodes<2>& nodes) {
    std::vector<Face<2>> faces;
    std::vector<int> index;  // as counted by Nodes::wall
    int count = 0;
    for (std::size_t k = 0; k < mesh.patches.size(); ++k)
        for (const auto& face : mesh.patches[k].faces) {
            if (isWall[k]) {
                faces.push_back(face);
                index.push_back(count);
            }
            ++count;
        }
    for (const auto& wall : faces)
        for (int corner : wall) {
            nodes.wall[corner] = -1;
            for (std::size_t w = 0; w < faces.size(); ++w) {
                const auto [a, b] = faces[w];
                if (a == corner || b == corner) continue;
                if (liesOn(nodes.x[corner], nodes.x[a], nodes.x[b], 1e-6 * nodes.h[corner])) nodes.wall[corner] = index[w];
            }
        }
}

}  // namespace pfem
