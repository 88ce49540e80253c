#include <algorithm>
#include <memory>
#include <set>

#include "mesh/simplex.hpp"
#include "mesher/space/spaceDraft.hpp"

namespace pfem {

namespace {

/// Does a face of the mesh lie on one of these triangles' surface? Its corners are on it, and it looks the same way.
bool liesOn(const BoxTree& tree, const Points<3>& x, const Face<3>& face) {
    const Vec<3> area = faceArea<3>(x, face);
    const double width = std::sqrt(area.norm()), tolerance = 1e-6 * width;
    for (const int i : face)
        if (tree.nearest(x[i], tolerance).second < 0) return false;
    const Vec<3> centre = (x[face[0]] + x[face[1]] + x[face[2]]) / 3;
    const int nearest = tree.nearest(centre, 0.3 * width).second;
    if (nearest < 0) return false;
    const auto& t = tree.triangle(nearest);
    return std::abs((t[1] - t[0]).cross(t[2] - t[0]).normalized().dot(area.normalized())) > 0.7;
}

}  // namespace

std::vector<Face<3>> selectedFaces(const SpaceDescription& description, const FaceSelection& selection,
                                   const Points<3>& x, const std::vector<Face<3>>& boundary) {
    std::vector<BoxTree> trees;
    for (const auto& [g, region] : selection.regions) {
        const auto& surface = description.geometries[g].surface;
        std::vector<BoxTree::Triangle> triangles;
        for (int k = 0; k < surface.size(); ++k)
            if (const auto& [a, b, c] = surface.triangles[k]; region < 0 || surface.region[k] == region)
                triangles.push_back({surface.x[a], surface.x[b], surface.x[c]});
        trees.emplace_back(std::move(triangles));
    }
    std::vector<Face<3>> faces;
    for (const auto& face : boundary) {
        const bool inBox = selection.box && std::all_of(face.begin(), face.end(), [&](int i) {
                               const Vec<3> slack = 1e-6 * ((*selection.box)[1] - (*selection.box)[0]).cwiseAbs();
                               return ((*selection.box)[0] - slack - x[i]).maxCoeff() <= 0 &&
                                      (x[i] - slack - (*selection.box)[1]).maxCoeff() <= 0;
                           });
        const auto onIt = [&](const BoxTree& tree) { return liesOn(tree, x, face); };
        if (inBox || std::any_of(trees.begin(), trees.end(), onIt)) faces.push_back(face);
    }
    return faces;
}

}  // namespace pfem
