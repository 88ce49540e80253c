#include "mesh/adjacency.hpp"

#include <algorithm>

#include "base/parallel.hpp"
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

namespace {

/// Write `values` in ascending order; none is twice among them.
void writeSorted(const std::vector<int>& values, int* to) {
    for (int value : values) {  // counting is quicker than moving: no branches
        int rank = 0;
        for (int other : values) rank += other < value;
        to[rank] = value;
    }
}

}  // namespace

template <int Dim>
NodeToNodes nodeToNodes(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around) {
    const int nNodes = static_cast<int>(around.start.size()) - 1;
    std::vector<int> ring(around.cell.size() * Dim);  // of node i: from Dim * around.start[i] on
    NodeToNodes result;
    result.start.assign(around.start.size(), 0);
#pragma omp parallel if (cells.size() > shortLoop)
    {
        std::vector<int> found;
#pragma omp for schedule(static)
        for (int i = 0; i < nNodes; ++i) {
            found.clear();
            for (int s = around.start[i]; s < around.start[i + 1]; ++s)
                for (int k = 1; k <= Dim; ++k) {
                    const int node = cells[around.cell[s]][(around.corner[s] + k) % (Dim + 1)];
                    bool known = false;
                    for (int other : found) known |= other == node;
                    if (!known) found.push_back(node);
                }
            writeSorted(found, ring.data() + static_cast<std::ptrdiff_t>(Dim) * around.start[i]);
            result.start[i + 1] = static_cast<int>(found.size());
        }
    }
    for (int i = 0; i < nNodes; ++i) result.start[i + 1] += result.start[i];
    result.node.resize(result.start[nNodes]);
#pragma omp parallel for schedule(static) if (cells.size() > shortLoop)
    for (int i = 0; i < nNodes; ++i)
        std::copy_n(ring.data() + static_cast<std::ptrdiff_t>(Dim) * around.start[i],
                    result.start[i + 1] - result.start[i], result.node.data() + result.start[i]);
    return result;
}

template <int Dim>
std::vector<BoundaryFace<Dim>> boundaryFaces(const std::vector<Simplex<Dim>>& cells,
                                             const NodeToCells& around) {
    const auto isShared = [&](int e, const Face<Dim>& face) {
        for (int s = around.start[face[0]]; s < around.start[face[0] + 1]; ++s) {
            const auto& other = cells[around.cell[s]];
            if (around.cell[s] == e) continue;
            bool all = true;
            for (int l = 1; l < Dim; ++l) {
                bool has = false;
                for (int k = 1; k <= Dim; ++k) has |= other[(around.corner[s] + k) % (Dim + 1)] == face[l];
                all &= has;
            }
            if (all) return true;
        }
        return false;
    };
    std::vector<unsigned char> open(cells.size(), 0);  // bit k: the face opposite to node k
#pragma omp parallel for schedule(static) if (cells.size() > shortLoop)
    for (int e = 0; e < static_cast<int>(cells.size()); ++e)
        for (int k = 0; k <= Dim; ++k)
            if (!isShared(e, oppositeFace<Dim>(cells[e], k))) open[e] |= static_cast<unsigned char>(1 << k);
    std::vector<BoundaryFace<Dim>> boundary;
    for (int e = 0; e < static_cast<int>(cells.size()); ++e)
        for (int k = 0; open[e] != 0 && k <= Dim; ++k)
            if (open[e] & (1 << k)) boundary.push_back({oppositeFace<Dim>(cells[e], k), e, k});
    return boundary;
}

template NodeToCells nodeToCells<2>(const std::vector<Simplex<2>>&, int);
template NodeToNodes nodeToNodes<2>(const std::vector<Simplex<2>>&, const NodeToCells&);
template std::vector<BoundaryFace<2>> boundaryFaces<2>(const std::vector<Simplex<2>>&, const NodeToCells&);
template NodeToCells nodeToCells<3>(const std::vector<Simplex<3>>&, int);
template NodeToNodes nodeToNodes<3>(const std::vector<Simplex<3>>&, const NodeToCells&);
template std::vector<BoundaryFace<3>> boundaryFaces<3>(const std::vector<Simplex<3>>&, const NodeToCells&);

}  // namespace pfem
