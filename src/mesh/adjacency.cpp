#include "mesh/adjacency.hpp"

#include <algorithm>

#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
NodeToCells nodeToCells(const std::vector<Simplex<Dim>>& cells, int nNodes) {
    NodeToCells around;
    around.start.assign(static_cast<std::size_t>(nNodes) + 1, 0);
    for (const auto& s : cells)
        for (int node : s) ++around.start[node + 1];
    for (int i = 0; i < nNodes; ++i) around.start[i + 1] += around.start[i];
    around.cell.resize(cells.size() * (Dim + 1));
    around.corner.resize(cells.size() * (Dim + 1));
    std::vector<int> next(around.start.begin(), around.start.end() - 1);
    for (int e = 0; e < static_cast<int>(cells.size()); ++e)
        for (int k = 0; k <= Dim; ++k) {
            const int slot = next[cells[e][k]]++;
            around.cell[slot] = e;
            around.corner[slot] = k;
        }
    return around;
}

template <int Dim>
NodeToNodes nodeToNodes(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around) {
    NodeToNodes result;
    const int nNodes = static_cast<int>(around.start.size()) - 1;
    result.start.assign(around.start.size(), 0);
    result.node.reserve(cells.size() * (Dim + 2));
    std::vector<int> ring;
    for (int i = 0; i < nNodes; ++i) {
        ring.clear();
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            for (int node : cells[around.cell[s]])
                if (node != i) ring.push_back(node);
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        result.node.insert(result.node.end(), ring.begin(), ring.end());
        result.start[i + 1] = static_cast<int>(result.node.size());
    }
    return result;
}

template <int Dim>
std::vector<BoundaryFace<Dim>> boundaryFaces(const std::vector<Simplex<Dim>>& cells,
                                             const NodeToCells& around) {
    std::vector<BoundaryFace<Dim>> boundary;
    for (int e = 0; e < static_cast<int>(cells.size()); ++e)
        for (int k = 0; k <= Dim; ++k) {
            const Face<Dim> face = oppositeFace<Dim>(cells[e], k);
            bool shared = false;
            for (int s = around.start[face[0]]; s < around.start[face[0] + 1] && !shared; ++s) {
                const int other = around.cell[s];
                if (other == e) continue;
                shared = std::all_of(face.begin() + 1, face.end(), [&](int node) {
                    return std::find(cells[other].begin(), cells[other].end(), node) != cells[other].end();
                });
            }
            if (!shared) boundary.push_back({face, e, k});
        }
    return boundary;
}

template NodeToCells nodeToCells<2>(const std::vector<Simplex<2>>&, int);
template NodeToNodes nodeToNodes<2>(const std::vector<Simplex<2>>&, const NodeToCells&);
template std::vector<BoundaryFace<2>> boundaryFaces<2>(const std::vector<Simplex<2>>&, const NodeToCells&);
template NodeToCells nodeToCells<3>(const std::vector<Simplex<3>>&, int);
template NodeToNodes nodeToNodes<3>(const std::vector<Simplex<3>>&, const NodeToCells&);
template std::vector<BoundaryFace<3>> boundaryFaces<3>(const std::vector<Simplex<3>>&, const NodeToCells&);

}  // namespace pfem
