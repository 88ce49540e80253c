#include "walls/skins.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "mesh/sortedFace.hpp"
#include "mesh/wallBins.hpp"

namespace pfem {

namespace {

/// Turn the faces of skins so that the solid is behind them.
template <int Dim>
void turnSkins(const std::vector<PatchKind>& kinds, const NodeToCells& aroundSolid, Mesh<Dim>& mesh) {
    std::map<Face<Dim>, Face<Dim>> seenFromOutside;
    for (const auto& face : boundaryFaces<Dim>(mesh.solid.nodes, aroundSolid)) {
        Face<Dim> turned = face.nodes;
        std::swap(turned[0], turned[1]);
        seenFromOutside[sorted<Dim>(turned)] = turned;
    }
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        if (kinds[k] != PatchKind::skin) continue;
        for (auto& face : mesh.patches[k].faces) face = seenFromOutside.at(sorted<Dim>(face));
    }
}

/// Velocity of the fluid beside node i: the mean of its neighbours off the solids; its own where there are none.
template <int Dim>
Vec<Dim> velocityBeside(const Topology<Dim>& topology, const Points<Dim>& v, int i) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    int count = 0;
    for (int s = topology.ring.start[i]; s < topology.ring.start[i + 1]; ++s) {
        if (topology.onSolid[topology.ring.node[s]]) continue;
        sum += v[topology.ring.node[s]];
        ++count;
    }
    return count > 0 ? Vec<Dim>(sum / count) : v[i];
}

/// Copies of the nodes that the fluid shares with solids under skins, by node.
template <int Dim>
std::map<int, int> copyShared(const Topology<Dim>& topology, State<Dim>& state) {
    std::map<int, int> copies;
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (!topology.isUnderSkin(i) || !topology.wet(i)) continue;
        copies[i] = state.nodes.size();
        state.nodes.append(Nodes<Dim>(state.nodes), i);
        state.nodes.id.back() = state.nextId++;
        state.nodes.sigma.back().setZero();
        state.nodes.v.back() = velocityBeside<Dim>(topology, state.nodes.v, i);
        state.nodes.p[i] = state.nodes.lostVolume[i] = 0;
        for (auto& [cause, amounts] : state.ledger.fields()) amounts.push_back(0.0);
    }
    return copies;
}

}  // namespace

template <int Dim>
void separateFromSkins(const std::vector<PatchKind>& kinds, State<Dim>& state) {
    if (std::find(kinds.begin(), kinds.end(), PatchKind::skin) == kinds.end()) return;
    turnSkins<Dim>(kinds, nodeToCells<Dim>(state.mesh.solid.nodes, state.nodes.size()), state.mesh);
    const auto topology = makeTopology<Dim>(state.mesh, kinds, state.nodes.x, state.nodes.wall);
    const auto copies = copyShared<Dim>(topology, state);
    const auto toCopies = [&](auto& nodes) {
        for (int& node : nodes)
            if (const auto copy = copies.find(node); copy != copies.end()) node = copy->second;
    };
    for (auto& cell : state.mesh.fluid.nodes) toCopies(cell);
    std::set<Face<Dim>> ofSolids;
    for (const auto& face : topology.solidFaces) ofSolids.insert(sorted<Dim>(face.nodes));
    for (auto& patch : state.mesh.patches)  // planes that cut the fluid
        for (auto& face : patch.faces)
            if (ofSolids.count(sorted<Dim>(face)) == 0) toCopies(face);
    const WallBins<Dim> places(topology.walls, state.nodes.x);
    for (const auto& [node, copy] : copies)
        state.nodes.wall[copy] = places.supportsAt(state.nodes.x[copy], 1e-6 * state.nodes.h[copy]);
}

template void separateFromSkins<2>(const std::vector<PatchKind>&, State<2>&);
template void separateFromSkins<3>(const std::vector<PatchKind>&, State<3>&);

}  // namespace pfem
