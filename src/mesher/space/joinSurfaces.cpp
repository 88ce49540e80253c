#include "mesher/space/joinSurfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mesh/distance.hpp"
#include "mesh/simplex.hpp"
#include "mesher/space/checkSurface.hpp"

namespace pfem {

namespace {

constexpr double touching = 1e-4, apart = 0.1;  // of the size

/// Those of bodies and of walls.
std::set<int> used(const SpaceDescription& description, bool walls) {
    std::set<int> shapes;
    for (const auto& body : description.bodies)
        for (const auto* list : {&body.space.all, &body.space.within, &body.space.without})
            shapes.insert(list->begin(), list->end());
    for (const auto& wall : description.walls)
        if (walls) shapes.insert(wall.geometry);
    return shapes;
}

BoxTree treeOf(const TriSurface& surface) {
    std::vector<BoxTree::Triangle> triangles;
    for (const auto& [a, b, c] : surface.triangles) triangles.push_back({surface.x[a], surface.x[b], surface.x[c]});
    return BoxTree(std::move(triangles));
}

/// Planes of the axes: x = c of all triangles that lie in one, each value once.
std::array<std::vector<double>, 3> axisPlanes(const SpaceDescription& description, double tolerance) {
    std::array<std::vector<double>, 3> planes;
    for (const int g : used(description, true)) {
        const auto& s = description.geometries[g].surface;
        for (const auto& [a, b, c] : s.triangles)
            for (int d = 0; d < 3; ++d) {
                const double at = s.x[a][d];
                if (s.x[b][d] != at || s.x[c][d] != at) continue;
                if (std::none_of(planes[d].begin(), planes[d].end(),
                                 [&](double known) { return std::abs(known - at) <= tolerance; }))
                    planes[d].push_back(at);
            }
    }
    return planes;
}

/// Onto the nearest corner, else the nearest triangle, of a shape that is near enough.
Vec<3> movedOnto(const TriSurface& surface, const BoxTree& tree, const Vec<3>& x, double tolerance) {
    const int k = tree.nearest(x, tolerance).second;
    if (k < 0) return x;
    for (const int i : surface.triangles[k])
        if ((surface.x[i] - x).norm() <= tolerance) return surface.x[i];
    const auto& t = tree.triangle(k);
    const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    return x - n.dot(x - t[0]) * n;
}

/// Distance of x from the triangles with nearly this normal where none of them is touched; 0: there is none near.
double distanceAlong(const BoxTree& tree, const Vec<3>& x, const Vec<3>& normal, double size) {
    double least = apart * size;
    const Vec<3> reach = Vec<3>::Constant(apart * size);
    tree.forEachIn(x - reach, x + reach, [&](int k) {
        const auto& t = tree.triangle(k);
        const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
        if (std::abs(n.dot(normal)) < 0.97) return;
        const double distance = distanceToFace<3>({t[0], t[1], t[2]}, {0, 1, 2}, x);
        const bool beside = distance > 0 && std::abs(n.dot(x - t[0])) <= touching * size;  // in the same plane
        least = std::min(least, beside ? 0 : distance);
    });
    return least < apart * size && least > touching * size ? least : 0;
}

}  // namespace

void joinSurfaces(SpaceDescription& description, double size) {
    const double tolerance = touching * size;
    const auto planes = axisPlanes(description, tolerance);
    std::vector<int> before;
    std::vector<BoxTree> trees;
    for (const int g : used(description, true)) {
        auto& surface = description.geometries[g].surface;
        for (auto& x : surface.x) {
            for (int d = 0; d < 3; ++d)
                for (const double plane : planes[d])
                    if (std::abs(x[d] - plane) <= tolerance) x[d] = plane;
            for (std::size_t k = 0; k < before.size(); ++k)
                x = movedOnto(description.geometries[before[k]].surface, trees[k], x, tolerance);
        }
        before.push_back(g);
        trees.push_back(treeOf(surface));
    }
}

void checkGaps(const SpaceDescription& description, double size) {
    const auto ofBodies = used(description, false), all = used(description, true);
    for (const int g : ofBodies) {
        const BoxTree tree = treeOf(description.geometries[g].surface);
        for (const int other : all) {
            if (other == g) continue;
            const auto& geometry = description.geometries[other];
            const auto& s = geometry.surface;
            for (const auto& face : s.triangles) {
                const Vec<3> normal = faceArea<3>(s.x, face).normalized();
                for (const int i : face) {
                    const double distance = distanceAlong(tree, s.x[i], normal, size);
                    if (distance == 0) continue;
                    throw UserError(
                        fmt::format(
                            "The shapes '{}' and '{}' run along each other at a distance of {:.3g} near {}: less than "
                            "a tenth of the meshSize {:g}. Let them touch, or keep them apart",
                            description.geometries[g].name, geometry.name, distance, placeOf(s.x[i]), size),
                        geometry.places.of());
                }
            }
        }
    }
}

}  // namespace pfem
