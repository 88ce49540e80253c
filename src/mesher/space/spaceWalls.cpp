#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "mesh/simplex.hpp"
#include "mesher/space/checkSurface.hpp"
#include "mesher/space/spaceDraft.hpp"

namespace pfem {

namespace {

/// The triangles of a wall that are not left open.
TriSurface wallSurface(const SpaceDescription& description, const SpaceWall& wall) {
    const auto& whole = description.geometries[wall.geometry].surface;
    TriSurface kept;
    kept.x = whole.x;
    kept.regions = whole.regions;
    for (int k = 0; k < whole.size(); ++k)
        if (!wall.open[whole.region[k]]) {
            kept.triangles.push_back(whole.triangles[k]);
            kept.region.push_back(whole.region[k]);
        }
    return kept;
}

/// The side of a closed surface on which most of the fluid is.
bool isOutside(const TriSurface& surface, const State<3>& state) {
    const InsideTest inside(surface);
    int in = 0, out = 0;
    for (const auto& cell : state.mesh.fluid.nodes) ++(inside(simplexCentroid<3>(state.nodes.x, cell)) ? in : out);
    return out > in;
}

/// The side of an open surface towards the fluid nearest to it: does the normal point there?
bool looksAtFluid(const TriSurface& surface, const State<3>& state) {
    std::vector<BoxTree::Triangle> triangles;
    for (const auto& [a, b, c] : surface.triangles) triangles.push_back({surface.x[a], surface.x[b], surface.x[c]});
    const BoxTree tree(triangles);
    std::vector<std::pair<double, int>> votes;  // distance of a fluid cell, and its side
    const double most = 1e30;
    for (const auto& cell : state.mesh.fluid.nodes) {
        const Vec<3> x = simplexCentroid<3>(state.nodes.x, cell);
        const auto [distance, k] = tree.nearest(x, most);
        const auto& t = triangles[k];
        const double height = (t[1] - t[0]).cross(t[2] - t[0]).normalized().dot(x - t[0]);
        if (std::abs(height) > 0.5 * distance) votes.emplace_back(distance, height > 0 ? 1 : -1);
    }
    std::sort(votes.begin(), votes.end());
    int sum = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(votes.size(), 100); ++k) sum += votes[k].second;
    return sum > 0;
}

/// Must the surface be turned, so that its normals point away from the fluid?
bool mustTurn(const SpaceDescription& description, const SpaceWall& wall, const TriSurface& surface,
              const State<3>& state) {
    const auto& geometry = description.geometries[wall.geometry];
    if (wall.side == WallSide::inside) return false;
    if (wall.side == WallSide::outside) return true;
    return geometry.closed ? isOutside(geometry.surface, state) : looksAtFluid(surface, state);
}

}  // namespace

void addWalls(const SpaceDescription& description, State<3>& state, std::vector<std::string>& warnings) {
    std::map<std::array<double, 3>, int> shared;  // nodes that walls at rest have in common
    for (const auto& wall : description.walls) {
        const TriSurface surface = wallSurface(description, wall);
        const bool turn = mustTurn(description, wall, surface, state);
        const double size = description.meshSize;
        const auto& h = state.nodes.h;
        const double smallest = h.empty() ? 1 : *std::min_element(h.begin(), h.end());
        std::vector<int> number(surface.x.size(), -1);
        const auto node = [&](int point) {
            if (number[point] >= 0) return number[point];
            const Vec<3>& x = surface.x[point];
            const std::array<double, 3> place{x[0], x[1], x[2]};
            if (const auto known = shared.find(place); !wall.moving && known != shared.end())
                return number[point] = known->second;
            const int i = state.nodes.size();
            state.nodes.resize(i + 1);
            state.nodes.id[i] = state.nextId++;
            state.nodes.x[i] = state.nodes.X[i] = x;
            state.nodes.h[i] = size > 0 ? size : smallest;
            if (!wall.moving) shared[place] = i;
            return number[point] = i;
        };
        Patch<3> patch{wall.name, {}};
        for (auto [a, b, c] : surface.triangles) {
            const int i = node(a), j = node(b), k = node(c);
            patch.faces.push_back(turn ? Face<3>{i, k, j} : Face<3>{i, j, k});
        }
        if (patch.faces.empty()) warnings.push_back(fmt::format("wall '{}' is open on all of its sides", wall.name));
        state.mesh.patches.push_back(patch);
    }
}

}  // namespace pfem
