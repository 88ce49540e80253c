#include "walls/wallPoints.hpp"

#include <map>

#include "mesh/adjacency.hpp"
#include "mesh/wallBins.hpp"

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

}  // namespace

template <int Dim>
void separateFromWalls(const std::vector<bool>& isWall, State<Dim>& state) {
    const auto wet = nodesIn<Dim>(state.mesh.fluid.nodes, state.nodes.size());
    const auto solid = nodesIn<Dim>(state.mesh.solid.nodes, state.nodes.size());
    auto ofBody = wet;
    for (std::size_t i = 0; i < wet.size(); ++i) ofBody[i] |= solid[i];
    copySharedPoints<Dim>(isWall, ofBody, state);
    const auto walls = wallFaces<Dim>(state.mesh.patches, isWall, state.nodes.x);
    const WallBins<Dim> places(walls, state.nodes.x);
    for (std::size_t i = 0; i < wet.size(); ++i) {
        if (!wet[i] || solid[i]) continue;
        Vec<Dim>& x = state.nodes.x[i];
        state.nodes.wall[i] = places.supportsAt(x, 1e-6 * state.nodes.h[i]);
        if (nSupports(state.nodes.wall[i]) != 1) continue;
        x = state.nodes.X[i] =
            placeOnRegion<Dim>(walls, state.nodes.x, state.nodes.wall[i][0], x).x;  // where it is bent
    }
}

template void separateFromWalls<2>(const std::vector<bool>&, State<2>&);
template void separateFromWalls<3>(const std::vector<bool>&, State<3>&);

}  // namespace pfem
