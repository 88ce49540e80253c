#pragma once
// What hangs together by nodes.

#include <algorithm>
#include <numeric>
#include <vector>

namespace pfem {

/// Per node of nNodes the lowest node with which it hangs together through `groups` of nodes (cells, faces).
template <class Groups>
std::vector<int> components(const Groups& groups, int nNodes) {
    std::vector<int> parent(nNodes);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const auto& group : groups)
        for (const int node : group) {
            const int a = root(node), b = root(group[0]);
            parent[std::max(a, b)] = std::min(a, b);
        }
    for (int i = 0; i < nNodes; ++i) parent[i] = root(i);
    return parent;
}

}  // namespace pfem
