#include "picture/skin.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace pfem {

namespace {

Vec<3> areaOf(const Face<3>& face, const Points<3>& x) {
    return 0.5 * (x[face[1]] - x[face[0]]).cross(x[face[2]] - x[face[0]]);
}

}  // namespace

std::vector<SkinEdge> skinEdges(const std::vector<Face<3>>& faces) {
    std::vector<std::tuple<int, int, int>> sides;  // nodes in ascending order, face
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(faces[f][k], faces[f][(k + 1) % 3]);
            sides.emplace_back(a, b, f);
        }
    std::sort(sides.begin(), sides.end());
    std::vector<SkinEdge> edges;
    for (const auto& [a, b, f] : sides) {
        if (edges.empty() || edges.back().a != a || edges.back().b != b) edges.push_back({a, b, {f, -1}, 0});
        if (++edges.back().count == 2) edges.back().faces[1] = f;
    }
    return edges;
}

Points<3> faceNormals(const std::vector<Face<3>>& faces, const Points<3>& x) {
    Points<3> normals;
    normals.reserve(faces.size());
    for (const Face<3>& face : faces) normals.push_back(areaOf(face, x).normalized());
    return normals;
}

std::vector<std::array<Vec<3>, 3>> cornerNormals(const std::vector<Face<3>>& faces, const Points<3>& x) {
    const double least = std::cos(creaseAngle * 3.141592653589793 / 180);
    const Points<3> normals = faceNormals(faces, x);
    std::vector<std::pair<int, int>> atNodes;  // node, face
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
        for (const int node : faces[f]) atNodes.emplace_back(node, f);
    std::sort(atNodes.begin(), atNodes.end());
    std::vector<std::array<Vec<3>, 3>> result(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            Vec<3> sum = Vec<3>::Zero();
            const int node = faces[f][k];
            for (auto at = std::lower_bound(atNodes.begin(), atNodes.end(), std::pair(node, -1));
                 at != atNodes.end() && at->first == node; ++at)
                if (normals[at->second].dot(normals[f]) > least) sum += areaOf(faces[at->second], x);
            result[f][k] = sum.norm() > 0 ? Vec<3>(sum.normalized()) : normals[f];
        }
    return result;
}

}  // namespace pfem
