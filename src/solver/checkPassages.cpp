#include "solver/checkPassages.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "mesh/distance.hpp"
#include "mesh/passages.hpp"
#include "mesh/simplex.hpp"
#include "mesh/wallBins.hpp"
#include "solver/failedStep.hpp"
#include "state/images.hpp"

namespace pfem {

namespace {

/// Old positions of the nodes of `next` that exist in `last`; of the others, and of images, the new ones. Of a node
/// that has gone through a periodic side, that of its image.
template <int Dim>
Points<Dim> oldPositions(const State<Dim>& last, const State<Dim>& next) {
    const auto images = imagesOf<Dim>(last);
    const auto& [before, now] = std::tie(last.nodes, next.nodes);
    std::vector<Points<Dim>> ofImages(images.empty() ? 0 : images.nOwn);
    for (int i = images.nOwn; i < before.size(); ++i) ofImages[images.master[i]].push_back(before.x[i]);
    Points<Dim> x = now.x;
    const int n = nOwnNodes<Dim>(next);
    for (int i = 0, j = 0; i < n; ++i) {  // both sorted by id
        while (j < images.nOwn && before.id[j] < now.id[i]) ++j;
        if (j == images.nOwn || before.id[j] != now.id[i]) continue;
        x[i] = before.x[j];
        if (images.empty()) continue;
        for (const Vec<Dim>& other : ofImages[j])
            if ((other - now.x[i]).norm() < (x[i] - now.x[i]).norm()) x[i] = other;
    }
    return x;
}

/// Walls with the nodes of their faces as they are counted in `next`: faces of patches keep their corners.
template <int Dim>
std::vector<WallFace<Dim>> wallsIn(const Topology<Dim>& topology, const State<Dim>& next) {
    std::vector<WallFace<Dim>> walls = topology.walls;
    std::size_t w = 0;
    for (const auto& patch : next.mesh.patches)
        for (const auto& face : patch.faces) walls[w++].nodes = face;
    return walls;
}

/// Nodes that went through rigid walls.
template <int Dim>
void checkWalls(const Topology<Dim>& topology, const Points<Dim>& xOld, const State<Dim>& next) {
    const auto held = keptNodes<Dim>(next.mesh, next.nodes.size());  // solids and corners go their own ways
    const auto walls = wallsIn<Dim>(topology, next);
    NumberedFaces<Dim> faces;
    for (int w = 0; w < static_cast<int>(walls.size()); ++w)
        if (walls[w].patch >= 0) faces.emplace_back(w, walls[w].nodes);
    const Passages<Dim> passages(std::move(faces), next.nodes.x, xOld);
    std::vector<int> through(next.nodes.size(), -1);
    parallelFor(next.nodes.size(), [&](int i) {
        if (isSupported(next.nodes.wall[i]) || held[i]) return;
        through[i] = passages.through(xOld[i], next.nodes.x[i], 0.01 * next.nodes.h[i]);
    });
    for (int i = 0; i < next.nodes.size(); ++i)
        if (through[i] >= 0)
            failAt<Dim>(next.nodes, i,
                        "went through the wall '" + next.mesh.patches[walls[through[i]].patch].name + "'");
}

/// Nodes of solids that have gone through walls: half of h behind the nearest face, in front of whose line they began.
template <int Dim>
void checkSolidsAtWalls(const Topology<Dim>& topology, const State<Dim>& next) {
    const Nodes<Dim>& nodes = next.nodes;
    const auto depth = [&](const Face<Dim>& face, const Points<Dim>& x, int i) {
        return faceArea<Dim>(x, face).normalized().dot(x[i] - x[face[0]]);
    };
    auto walls = wallsIn<Dim>(topology, next);
    for (int w = 0; w < static_cast<int>(walls.size()); ++w)
        if (topology.isSkin(w)) walls[w].patch = -1;  // rigid ones
    const WallBins<Dim> places(walls, nodes.x);
    std::vector<unsigned char> seen(nodes.x.size(), 0);
    for (int e = 0; e < next.mesh.solid.size(); ++e)
        for (const int i : next.mesh.solid.nodes[e]) {
            if (std::exchange(seen[i], 1)) continue;
            const double h = nodes.h[i];
            double nearest = 2 * h;
            int wall = -1;
            places.forEachNear(nodes.x[i], nodes.x[i], nearest, [&](int one) {
                const double d = distanceToFace<Dim>(nodes.x, walls[one].nodes, nodes.x[i]);
                if (d >= nearest) return;
                nearest = d;
                wall = one;
            });
            if (wall < 0 || nearest < 0.5 * h) continue;
            const auto& [face, patch] = std::pair(walls[wall].nodes, walls[wall].patch);
            if (depth(face, nodes.x, i) < 0.5 * h || depth(face, nodes.X, i) > 0.1 * h ||
                footWeights<Dim>(nodes.x, face, nodes.x[i]).minCoeff() < 0)
                continue;
            failAt<Dim>(
                nodes, i,
                fmt::format("of the solid '{}' went through the wall '{}': a file constant/contact makes solids "
                            "meet walls",
                            next.mesh.materials[next.mesh.solid.material[e]], next.mesh.patches[patch].name));
        }
}

/// Faces of the solids' surfaces, the fluid's side in front.
template <int Dim>
NumberedFaces<Dim> frontsOfSolids(const State<Dim>& state) {
    NumberedFaces<Dim> fronts;
    const auto& cells = state.mesh.solid.nodes;
    for (const auto& face : boundaryFaces<Dim>(cells, nodeToCells<Dim>(cells, state.nodes.size()))) {
        Face<Dim> front = face.nodes;
        std::swap(front[0], front[1]);
        fronts.emplace_back(static_cast<int>(fronts.size()), front);
    }
    return fronts;
}

/// Nodes that went through a solid. Only one that moves farther than half of the solid's mesh size can do so unseen:
/// what is inside a solid after a step has been put out again on the nearer side.
template <int Dim>
void checkSolids(const Points<Dim>& xOld, const State<Dim>& next) {
    if (next.mesh.solid.nodes.empty()) return;
    const Nodes<Dim>& nodes = next.nodes;
    std::vector<unsigned char> onSolid(nodes.id.size(), 0);
    double h = std::numeric_limits<double>::max(), solidMotion = 0;
    for (const auto& cell : next.mesh.solid.nodes)
        for (int i : cell) {
            onSolid[i] = 1;
            h = std::min(h, nodes.h[i]);
            solidMotion = std::max(solidMotion, (nodes.x[i] - xOld[i]).norm());
        }
    std::optional<Passages<Dim>> skin;
    for (int i = 0; i < nodes.size(); ++i) {
        if (onSolid[i] || (nodes.x[i] - xOld[i]).norm() + solidMotion < 0.5 * h) continue;
        if (!skin) skin.emplace(frontsOfSolids<Dim>(next), nodes.x, xOld);
        if (skin->through(xOld[i], nodes.x[i], 0.01 * h) >= 0) failAt<Dim>(nodes, i, "went through a solid");
    }
}

}  // namespace

template <int Dim>
void checkPassages(const Topology<Dim>& topology, const State<Dim>& last, const State<Dim>& next) {
    const Points<Dim> xOld = oldPositions<Dim>(last, next);
    checkWalls<Dim>(topology, xOld, next);
    checkSolidsAtWalls<Dim>(topology, next);
    checkSolids<Dim>(xOld, next);
}

#define PFEM_INSTANTIATE(D) template void checkPassages<D>(const Topology<D>&, const State<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
