#include "remesh/cellNeighbours.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// One side of a face, under its smallest node.
struct Side {
    int middle, largest;  // its other nodes
    int cell, opposite;

    bool operator<(const Side& other) const {
        return std::pair(middle, largest) < std::pair(other.middle, other.largest);
    }
};

}  // namespace

std::vector<std::array<int, 4>> cellNeighbours(const std::vector<Simplex<3>>& cells, int nNodes) {
    const int n = static_cast<int>(cells.size());
    const auto sortedFace = [&](int e, int k) {
        Face<3> face = oppositeFace<3>(cells[e], k);
        std::sort(face.begin(), face.end());
        return face;
    };
    std::vector<int> start(static_cast<std::size_t>(nNodes) + 1, 0);
    for (int e = 0; e < n; ++e)
        for (int k = 0; k < 4; ++k) ++start[sortedFace(e, k)[0] + 1];
    for (int i = 0; i < nNodes; ++i) start[i + 1] += start[i];
    std::vector<Side> sides(start[nNodes]);
    std::vector<int> next(start.begin(), start.end() - 1);
    for (int e = 0; e < n; ++e)
        for (int k = 0; k < 4; ++k) {
            const Face<3> face = sortedFace(e, k);
            sides[next[face[0]]++] = {face[1], face[2], e, k};
        }
    std::vector<std::array<int, 4>> neighbours(n, {-1, -1, -1, -1});
    parallelFor(nNodes, [&](int i) {
        std::sort(sides.begin() + start[i], sides.begin() + start[i + 1]);
        for (int s = start[i]; s + 1 < start[i + 1]; ++s) {
            const Side &a = sides[s], &b = sides[s + 1];
            if (a < b) continue;
            neighbours[a.cell][a.opposite] = b.cell;
            neighbours[b.cell][b.opposite] = a.cell;
        }
    });
    return neighbours;
}

}  // namespace pfem
