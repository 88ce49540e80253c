#pragma once
// Who takes over what a node leaves behind in a remeshing.

#include "remesh/movedMesh.hpp"

namespace pfem {

/// Indices of those that are marked.
inline std::vector<int> chosen(const std::vector<unsigned char>& marked) {
    std::vector<int> result;
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (marked[i]) result.push_back(static_cast<int>(i));
    return result;
}

/// The old neighbours of old node i that are still in the fluid, or the node that it has joined as a drop; new indices.
/// `newIndex`: of the old nodes, -1: gone.
template <int Dim>
std::vector<int> heirsOf(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex,
                         const std::vector<unsigned char>& wet, int i) {
    std::vector<int> heirs;
    const auto& ring = moved.topology.ring;
    if (!moved.joins.empty() && moved.joins[i] >= 0) {
        const int heir = newIndex[moved.joins[i]];
        if (heir >= 0 && wet[heir]) heirs.push_back(heir);
    }
    for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) {
        const int heir = newIndex[ring.node[s]];
        if (heir >= 0 && wet[heir]) heirs.push_back(heir);
    }
    return heirs;
}

}  // namespace pfem
