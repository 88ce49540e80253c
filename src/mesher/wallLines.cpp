#include "mesher/wallLines.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace pfem {

namespace {

/// How often a node is used by solids and patches, and its neighbours along one wall.
struct WallWalker {
    std::map<int, int> next, previous;
    std::set<int> meeting;  // nodes through which the wall runs more than once

    explicit WallWalker(const Patch<2>& patch) {
        for (const auto& [a, b] : patch.faces) {
            if (!next.emplace(a, b).second) meeting.insert(a);
            if (!previous.emplace(b, a).second) meeting.insert(b);
        }
    }
    bool isBetween(int node) const {
        return next.count(node) > 0 && previous.count(node) > 0 && meeting.count(node) == 0;
    }
};

bool isStraight(const Points<2>& x, int a, int b, int c) {
    const Vec<2> s = (x[b] - x[a]).normalized(), t = (x[c] - x[b]).normalized();
    return s.dot(t) > 0 && std::abs(s[0] * t[1] - s[1] * t[0]) < 1e-9;
}

/// Remove the nodes that are not `kept` and renumber all references.
void dropNodes(const std::vector<char>& kept, State<2>& state) {
    const Nodes<2> old = std::move(state.nodes);
    state.nodes = Nodes<2>();
    std::vector<int> rank(old.id.size(), -1);
    for (int i = 0; i < old.size(); ++i) {
        if (!kept[i]) continue;
        rank[i] = state.nodes.size();
        state.nodes.append(old, i);
        state.nodes.id.back() = rank[i];
    }
    for (auto* cells : {&state.mesh.fluid, &state.mesh.solid})
        for (auto& s : cells->nodes)
            for (int& node : s) node = rank[node];
    for (auto& patch : state.mesh.patches)
        for (auto& face : patch.faces)
            for (int& node : face) node = rank[node];
    state.nextId = state.nodes.size();
}

}  // namespace

void separateWalls(const std::vector<std::string>& walls, const std::vector<std::string>& moving, State<2>& state) {
    const auto isOneOf = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const auto& mover : state.mesh.patches) {
        if (!isOneOf(moving, mover.name)) continue;
        std::map<int, int> copies;  // of the mover's nodes that others have, too
        for (const auto& face : mover.faces)
            for (int node : face) copies[node] = -1;
        for (auto& other : state.mesh.patches) {
            if (other.name == mover.name || !isOneOf(walls, other.name)) continue;
            for (auto& face : other.faces)
                for (int& node : face) {
                    const auto shared = copies.find(node);
                    if (shared == copies.end()) continue;
                    if (shared->second < 0) {
                        shared->second = state.nodes.size();
                        state.nodes.append(Nodes<2>(state.nodes), node);
                        state.nodes.id.back() = state.nextId++;
                    }
                    node = shared->second;
                }
        }
    }
}

void straightenWalls(const std::vector<std::string>& walls, State<2>& state) {
    const int n = state.nodes.size();
    std::vector<char> wet(n, 0), pinned(n, 0), between(n, 0);
    for (const auto& s : state.mesh.fluid.nodes)
        for (int node : s) wet[node] = 1;
    for (const auto& s : state.mesh.solid.nodes)
        for (int node : s) pinned[node] = 1;
    const auto isWallName = [&](const std::string& name) {
        return std::find(walls.begin(), walls.end(), name) != walls.end();
    };
    for (const auto& patch : state.mesh.patches)
        if (!isWallName(patch.name))
            for (const auto& face : patch.faces)
                for (int node : face) pinned[node] = 1;

    for (auto& patch : state.mesh.patches) {
        if (!isWallName(patch.name)) continue;
        const WallWalker walker(patch);
        const auto isInner = [&](int node) {
            return walker.isBetween(node) && !pinned[node] &&
                   isStraight(state.nodes.x, walker.previous.at(node), node, walker.next.at(node));
        };
        std::vector<Face<2>> straight;
        for (const auto& [a, b] : patch.faces) {
            if (isInner(a)) continue;  // not the first face of a straight piece
            int end = b;
            for (; isInner(end); end = walker.next.at(end)) between[end] = 1;
            straight.push_back({a, end});
        }
        patch.faces = straight;
    }

    std::vector<char> kept(n, 1);
    for (int i = 0; i < n; ++i)
        if (between[i] && !wet[i]) kept[i] = 0;
    dropNodes(kept, state);
}

}  // namespace pfem
