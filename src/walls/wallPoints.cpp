#include "walls/wallPoints.hpp"

#include <algorithm>
#include <map>

#include "mesh/adjacency.hpp"
#include "mesh/distance.hpp"
#include "mesh/wallFaces.hpp"

namespace pfem {

namespace {

template <int Dim>
void copySharedPoints(const std::vector<bool>& isWall, const std::vector<unsigned char>& ofBody, State<Dim>& state) {
    std::map<int, int> copies;
    for (std::size_t k = 0; k < isWall.size(); ++k) {
        if (!isWall[k]) continue;
        for (auto& face : state.mesh.patches[k].faces)
            for (int& node : face) {
                if (node >= static_cast<int>(ofBody.size()) || !ofBody[node]) continue;
                const auto [copy, isNew] = copies.emplace(node, state.nodes.size());
                if (isNew) {
                    state.nodes.append(Nodes<Dim>(state.nodes), node);
                    state.nodes.id.back() = state.nextId++;
                    state.nodes.wall.back() = unsupported<Dim>();
                    state.nodes.p.back() = 0;
                    state.nodes.lostVolume.back() = 0;
                    for (auto& [cause, amounts] : state.ledger.fields()) amounts.push_back(0.0);
                }
                node = copy->second;
            }
    }
}

/// All regions of the walls on which x lies, by one face each.
template <int Dim>
Supports<Dim> supportsAt(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& points, const Vec<Dim>& x,
                         double near) {
    Supports<Dim> supports = unsupported<Dim>();
    for (int w = 0; w < static_cast<int>(walls.size()); ++w) {
        if (walls[w].patch < 0 || distanceToFace<Dim>(points, walls[w].nodes, x) > near) continue;
        const bool known = std::any_of(supports.begin(), supports.end(),
                                       [&](int face) { return face >= 0 && walls[face].region == walls[w].region; });
        if (!known) addSupport(supports, w);
    }
    return supports;
}

}  // namespace

template <int Dim>
void separateFromWalls(const std::vector<bool>& isWall, State<Dim>& state) {
    const auto wet = nodesIn<Dim>(state.mesh.fluid.nodes, state.nodes.size());
    const auto solid = nodesIn<Dim>(state.mesh.solid.nodes, state.nodes.size());
    auto ofBody = wet;
    for (std::size_t i = 0; i < wet.size(); ++i) ofBody[i] |= solid[i];
    copySharedPoints<Dim>(isWall, ofBody, state);
    const auto walls = wallFaces<Dim>(state.mesh.patches, isWall, state.nodes.x);
    for (std::size_t i = 0; i < wet.size(); ++i) {
        if (!wet[i] || solid[i]) continue;
        Vec<Dim>& x = state.nodes.x[i];
        state.nodes.wall[i] = supportsAt<Dim>(walls, state.nodes.x, x, 1e-6 * state.nodes.h[i]);
        if (nSupports(state.nodes.wall[i]) != 1) continue;
        x = state.nodes.X[i] =
            placeOnRegion<Dim>(walls, state.nodes.x, state.nodes.wall[i][0], x).x;  // where it is bent
    }
}

template void separateFromWalls<2>(const std::vector<bool>&, State<2>&);
template void separateFromWalls<3>(const std::vector<bool>&, State<3>&);

}  // namespace pfem
