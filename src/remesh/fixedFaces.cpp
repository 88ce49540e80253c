#include "remesh/fixedFaces.hpp"

#include <algorithm>
#include <tuple>

#include "mesh/adjacency.hpp"

namespace pfem {

namespace {

/// The place of each wall face in its region, from one end to the other.
std::vector<int> orderInRegion(const std::vector<WallFace<2>>& walls) {
    std::vector<int> order(walls.size(), -1);
    const auto walkFrom = [&](int face) {
        for (int count = 0; face >= 0 && order[face] < 0; ++count) {
            order[face] = count;
            face = walls[face].bend[0] == Bend::smooth ? walls[face].next[0] : -1;  // beyond its second node
        }
    };
    for (std::size_t w = 0; w < walls.size(); ++w)
        if (walls[w].patch >= 0 && walls[w].bend[1] != Bend::smooth) walkFrom(static_cast<int>(w));
    for (std::size_t w = 0; w < walls.size(); ++w)  // closed ones
        if (walls[w].patch >= 0) walkFrom(static_cast<int>(w));
    return order;
}

struct OnWall {
    int region, order, face;
    double along;
    int node;
};

/// All nodes on walls, in their order along them.
std::vector<OnWall> nodesOnWalls(const State<2>& state, const Topology<2>& topology, const std::vector<int>& newIndex) {
    const Points<2>& x = state.nodes.x;
    const auto order = orderInRegion(topology.walls);
    std::vector<OnWall> found;
    std::vector<Face<2>> faces;  // with the indices of now
    for (const auto& patch : state.mesh.patches) faces.insert(faces.end(), patch.faces.begin(), patch.faces.end());
    const auto add = [&](int node, const Supports<2>& supports) {
        for (const int w : supports) {
            if (w < 0) continue;
            const Vec<2> start = x[faces[w][0]];
            found.push_back(
                {topology.walls[w].region, order[w], w, (x[node] - start).dot(x[faces[w][1]] - start), node});
        }
    };
    for (int i = 0; i < state.nodes.size(); ++i) add(i, state.nodes.wall[i]);
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.onSolid[i] && !topology.isUnderSkin(i)) add(newIndex[i], topology.supports[i]);
    std::sort(found.begin(), found.end(), [](const OnWall& a, const OnWall& b) {
        return std::tie(a.region, a.order, a.along, a.node) < std::tie(b.region, b.order, b.along, b.node);
    });
    return found;
}

}  // namespace

template <>
std::vector<Face<2>> fixedFaces<2>(const State<2>& state, const std::vector<PatchKind>& kinds,
                                   const Topology<2>& topology, const std::vector<int>& newIndex) {
    std::vector<Face<2>> fixed;
    const auto& [x, h] = std::tie(state.nodes.x, state.nodes.h);
    const auto aroundSolid = nodeToCells<2>(state.mesh.solid.nodes, state.nodes.size());
    for (const auto& face : boundaryFaces<2>(state.mesh.solid.nodes, aroundSolid)) fixed.push_back(face.nodes);
    for (std::size_t k = 0; k < state.mesh.patches.size(); ++k)
        if (kinds[k] == PatchKind::symmetry)
            fixed.insert(fixed.end(), state.mesh.patches[k].faces.begin(), state.mesh.patches[k].faces.end());
    const auto found = nodesOnWalls(state, topology, newIndex);
    for (std::size_t k = 1; k < found.size(); ++k) {
        const OnWall &a = found[k - 1], &b = found[k];
        const double gap = (x[a.node] - x[b.node]).norm();
        if (a.region != b.region || a.node == b.node || gap == 0) continue;
        if (a.face == b.face || gap < 3 * std::max(h[a.node], h[b.node])) fixed.push_back({a.node, b.node});
    }
    return fixed;
}

template <>
std::vector<Face<3>> fixedFaces<3>(const State<3>&, const std::vector<PatchKind>&, const Topology<3>&,
                                   const std::vector<int>&) {
    return {};
}

}  // namespace pfem
