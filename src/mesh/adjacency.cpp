#include "mesh/adjacency.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "base/unset.hpp"
#include "mesh/sharedTopology.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

/// By blocks of cells: each counts what it has at each node, and so knows where to write.
template <int Dim>
NodeToCells nodeToCells(const std::vector<Simplex<Dim>>& cells, int nNodes) {
    const int nCells = static_cast<int>(cells.size()), nBlocks = nCells > shortLoop ? 4 : 1;
    std::vector<std::vector<int>> next(nBlocks, std::vector<int>(nNodes, 0));
    const auto forCells = [&](int block, const auto& visit) {
        const auto first = [&](std::int64_t b) { return static_cast<int>(b * nCells / nBlocks); };
        for (int e = first(block); e < first(block + 1); ++e)
            for (int k = 0; k <= Dim; ++k) visit(e, k, next[block][cells[e][k]]);
    };
    parallelTasks(nBlocks, [&](int b) { forCells(b, [](int, int, int& count) { ++count; }); });
    NodeToCells around;
    around.start.assign(static_cast<std::size_t>(nNodes) + 1, 0);
    for (int i = 0, slot = 0; i < nNodes; ++i) {
        for (auto& block : next) slot += std::exchange(block[i], slot);
        around.start[i + 1] = slot;
    }
    around.cell.resize(cells.size() * (Dim + 1));
    around.corner.resize(cells.size() * (Dim + 1));
    parallelTasks(nBlocks, [&](int b) {
        forCells(b, [&](int e, int k, int& slot) {
            around.cell[slot] = e;
            around.corner[slot++] = k;
        });
    });
    return around;
}

std::vector<std::size_t> nodeRuns(const Ranks& ranks, const NodeToCells& around) {
    std::vector<std::size_t> ends;
    for (const std::size_t slot : ranks.evenEnds(around.start.back()))
        ends.push_back(std::lower_bound(around.start.begin(), around.start.end() - 1, static_cast<int>(slot)) -
                       around.start.begin());
    ends.back() = around.start.size() - 1;
    return ends;
}

namespace {

/// First node of a rank's run and the one after its last.
struct NodeRun {
    int first, last;
    NodeRun(const Ranks& ranks, const std::vector<std::size_t>& ends)
        : first(ranks.beginOf(ends)), last(static_cast<int>(ends[ranks.rank()])) {}
};

/// In ascending order; none is twice among them.
void writeSorted(const std::vector<int>& nodes, int* to) {
    for (const int each : nodes) {  // counting is quicker than moving
        int rank = 0;
        for (const int other : nodes) rank += other < each;
        to[rank] = each;
    }
}

/// The neighbours of one node in the plane, as they are found in the cells around it: arrays, so that searches have no
/// branches.
struct Found {
    std::vector<int> node, times, cell;  // in how many cells, and the first of them

    void clear() {
        for (auto* list : {&node, &times, &cell}) list->clear();
    }
    void add(int n, int inCell) {
        int known = 0;
        for (std::size_t k = 0; k < node.size(); ++k) {
            const int same = node[k] == n;
            times[k] += same;
            known |= same;
        }
        if (known) return;
        node.push_back(n);
        times.push_back(1);
        cell.push_back(inCell);
    }
};

/// Looks around nodes in the plane; where an edge of one triangle alone leads to a neighbour, it is open.
struct RingInPlane {
    const std::vector<Simplex<2>>& cells;
    const NodeToCells& around;
    std::vector<unsigned char>& open;  // per cell and local node: is the face opposite to it of no other cell?
    Found found = {};

    const std::vector<int>& operator()(int i) {
        found.clear();
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            for (int k = 1; k <= 2; ++k) found.add(cells[around.cell[s]][(around.corner[s] + k) % 3], around.cell[s]);
        for (std::size_t f = 0; f < found.node.size(); ++f) {
            if (found.times[f] > 1 || found.node[f] < i) continue;
            const auto& s = cells[found.cell[f]];
            for (int k = 0; k <= 2; ++k)
                if (s[k] != i && s[k] != found.node[f]) open[found.cell[f] * 3 + k] = 1;
        }
        return found.node;
    }
};

/// In space. The cells around a node are triangles on a sphere around it, the neighbours their vertices: V vertices and
/// F triangles cover all of it when V - 3/2 F + F = 2 (Euler); where T triangles are missing and B of their edges are
/// open, V - F/2 is larger by T/2 less the vertices that are missing, which is (B - 2 chi)/2 > 0.
struct RingInSpace {
    const std::vector<Simplex<3>>& cells;
    const NodeToCells& around;
    std::vector<unsigned char>& isInside;  // per node: none of its faces is open
    std::vector<int> last = std::vector<int>(around.start.size() - 1, -1), ring = std::vector<int>(16);

    /// Nodes are written at the end of the ring, and stay there when they are new.
    const std::vector<int>& operator()(int i) {
        const int nCells = around.count(i);
        ring.resize(3 * static_cast<std::size_t>(nCells) + 1);
        std::size_t n = 0;
        last[i] = i;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            for (const int node : cells[around.cell[s]]) {
                ring[n] = node;
                n += last[node] != i;
                last[node] = i;
            }
        ring.resize(n);
        isInside[i] = 2 * static_cast<int>(n) == nCells + 4;
        return ring;
    }
};

/// `marks`: what the look around nodes finds beside them. `ends`: nodeRuns.
template <int Dim>
NodeToNodes nodeToNodes(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around, const Ranks& ranks,
                        const std::vector<std::size_t>& ends, std::vector<unsigned char>& marks) {
    const NodeRun run(ranks, ends);
    const int nNodes = static_cast<int>(around.start.size()) - 1;
    const auto ringAt = [&](int i) {
        return static_cast<std::ptrdiff_t>(Dim) * (around.start[i] - around.start[run.first]);
    };
    UnsetVector<int> ring(ringAt(run.last));
    std::vector<int> count(nNodes, 0);
    NodeToNodes result;
#pragma omp parallel if (cells.size() > shortLoop)
    {
        std::conditional_t<Dim == 2, RingInPlane, RingInSpace> ringOf{cells, around, marks};
#pragma omp for schedule(static)
        for (int i = run.first; i < run.last; ++i) {
            const std::vector<int>& nodes = ringOf(i);
            writeSorted(nodes, ring.data() + ringAt(i));
            count[i] = static_cast<int>(nodes.size());
        }
    }
    ranks.complete(count, ends);
    result.start.assign(around.start.size(), 0);
    for (int i = 0; i < nNodes; ++i) result.start[i + 1] = result.start[i] + count[i];
    result.node.resize(result.start[nNodes]);
#pragma omp parallel for schedule(static) if (cells.size() > shortLoop)
    for (int i = run.first; i < run.last; ++i)
        std::copy_n(ring.data() + ringAt(i), count[i], result.node.data() + result.start[i]);
    std::vector<std::size_t> entries;
    for (const std::size_t end : ends) entries.push_back(result.start[end]);
    ranks.complete(result.node, entries);
    return result;
}

/// A face among those whose lowest node is the same.
struct SeenFace {
    std::uint64_t others;  // its other nodes, the lower one first
    int at;                // Dim + 1 times its cell + corner

    bool operator<(const SeenFace& face) const { return others < face.others; }
};

/// The nodes of a face but for its lowest one, as one number.
template <int Dim>
std::uint64_t otherNodes(const Face<Dim>& face, int lowest) {
    std::uint64_t low = 0, high = 0;  // in the plane there is one
    for (const int node : face) {
        const auto other = static_cast<std::uint64_t>(node);
        if (node == lowest) continue;
        low = std::min(high, other);
        high = std::max(high, other);
    }
    return low << 32 | high;
}

/// Faces of one cell alone. Each face is looked for among those whose lowest node is the same, one of the run that is
/// not inside.
template <int Dim, class IsInside>
std::vector<unsigned char> openFaces(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around,
                                     const NodeRun& run, const IsInside& isInside) {
    std::vector<unsigned char> open(cells.size() * (Dim + 1), 0);
#pragma omp parallel if (cells.size() > shortLoop)
    {
        std::vector<SeenFace> seen;
#pragma omp for schedule(static)
        for (int i = run.first; i < run.last; ++i) {
            if (isInside(i)) continue;
            seen.clear();
            for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
                const auto& cell = cells[around.cell[s]];
                int lower = 0;  // nodes of the cell
                for (const int node : cell) lower += node < i;
                for (int k = 0; lower < 2 && k <= Dim; ++k)  // i is the lowest of the face opposite to the lower one
                    if (k != around.corner[s] && (lower == 0 || cell[k] < i))
                        seen.push_back(
                            {otherNodes<Dim>(oppositeFace<Dim>(cell, k), i), around.cell[s] * (Dim + 1) + k});
            }
            std::sort(seen.begin(), seen.end());
            for (std::size_t f = 0; f < seen.size(); ++f)
                open[seen[f].at] = (f == 0 || seen[f - 1].others != seen[f].others) &&
                                   (f + 1 == seen.size() || seen[f + 1].others != seen[f].others);
        }
    }
    return open;
}

/// The open ones in the order of cells: Dim + 1 times the cell + corner.
std::vector<int> listOf(const std::vector<unsigned char>& open) {
    return parallelChosen(static_cast<int>(open.size()), [&](int at) { return open[at] != 0; });
}

template <int Dim>
std::vector<BoundaryFace<Dim>> facesAt(const std::vector<Simplex<Dim>>& cells, const std::vector<int>& list) {
    std::vector<BoundaryFace<Dim>> boundary;
    for (const int at : list) {
        const int e = at / (Dim + 1), k = at % (Dim + 1);
        boundary.push_back({oppositeFace<Dim>(cells[e], k), e, k});
    }
    return boundary;
}

/// Those that each rank has found in its run, which are of any cells.
std::vector<int> openOfAll(const std::vector<unsigned char>& open, const Ranks& ranks) {
    auto list = ranks.gather(listOf(open));
    if (!ranks.isAlone()) std::sort(list.begin(), list.end());
    return list;
}

}  // namespace

template <int Dim>
std::vector<BoundaryFace<Dim>> boundaryFaces(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around) {
    const Ranks alone;
    return facesAt<Dim>(
        cells, listOf(openFaces<Dim>(cells, around, {alone, nodeRuns(alone, around)}, [](int) { return false; })));
}

template <int Dim>
Surroundings<Dim> surroundings(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around, const Ranks& ranks) {
    const auto ends = nodeRuns(ranks, around);
    std::vector<unsigned char> open, marks(Dim == 2 ? 3 * cells.size() : around.start.size() - 1, 0);
    auto ring = nodeToNodes<Dim>(cells, around, ranks, ends, marks);
    if (Dim == 2)
        open = std::move(marks);
    else
        open = openFaces<Dim>(cells, around, {ranks, ends}, [&](int i) { return marks[i] != 0; });
    return {std::move(ring), facesAt<Dim>(cells, openOfAll(open, ranks))};
}

template <int Dim>
Surroundings<Dim> surroundings(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around) {
    return surroundings<Dim>(cells, around, Ranks());
}

#define PFEM_INSTANTIATE(D)                                                                                     \
    template NodeToCells nodeToCells<D>(const std::vector<Simplex<D>>&, int);                                   \
    template std::vector<BoundaryFace<D>> boundaryFaces<D>(const std::vector<Simplex<D>>&, const NodeToCells&); \
    template Surroundings<D> surroundings<D>(const std::vector<Simplex<D>>&, const NodeToCells&, const Ranks&); \
    template Surroundings<D> surroundings<D>(const std::vector<Simplex<D>>&, const NodeToCells&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
