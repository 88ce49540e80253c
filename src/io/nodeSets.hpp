#pragma once
// Which nodes go into which file of a time folder. Internal to src/io.

#include <fmt/format.h>

#include <vector>

#include "base/error.hpp"
#include "state/state.hpp"

namespace pfem {

/// The nodes of one file: ascending indices into the state and the way back (-1: not in this file).
struct NodeSet {
    std::vector<int> nodes;
    std::vector<int> local;

    explicit NodeSet(const std::vector<char>& member) : local(member.size(), -1) {
        for (std::size_t i = 0; i < member.size(); ++i) {
            if (member[i] == 0) continue;
            local[i] = static_cast<int>(nodes.size());
            nodes.push_back(static_cast<int>(i));
        }
    }
    int size() const { return static_cast<int>(nodes.size()); }
};

template <class CellList>
void mark(std::vector<char>& member, const CellList& cells) {
    for (const auto& cell : cells)
        for (const int i : cell) {
            if (i < 0 || i >= static_cast<int>(member.size()))
                throw InternalError(fmt::format("writeState: cell refers to node {} of {}", i, member.size()));
            member[static_cast<std::size_t>(i)] = 1;
        }
}

/// Which nodes go into which file; a node may be in several, and is in one at least.
template <int Dim>
struct Membership {
    std::vector<char> fluid, solid, boundary;
    std::vector<int> isolated;  // in no cell and no patch

    explicit Membership(const State<Dim>& state) {
        const auto n = static_cast<std::size_t>(state.nodes.size());
        fluid.assign(n, 0);
        solid.assign(n, 0);
        boundary.assign(n, 0);
        mark(fluid, state.mesh.fluid.nodes);
        mark(solid, state.mesh.solid.nodes);
        for (const auto& patch : state.mesh.patches) mark(boundary, patch.faces);
        for (std::size_t i = 0; i < n; ++i)
            if (fluid[i] + solid[i] + boundary[i] == 0) {
                fluid[i] = 1;
                isolated.push_back(static_cast<int>(i));
            }
    }
};

}  // namespace pfem
