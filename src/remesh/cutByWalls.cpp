#include "remesh/cutByWalls.hpp"

#include <algorithm>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "mesh/wallScreen.hpp"

namespace pfem {

namespace {

constexpr double slack = 0.01;  // of h: farther behind a wall a node is behind it
constexpr double reach = 3;     // of h: no cell reaches farther through a wall

template <int Dim>
HeldPoint<Dim> pointOf(const CandidateNodes<Dim>& nodes, int i) {
    return {nodes.x[i], nodes.wall[i]};
}

template <int Dim>
std::vector<unsigned char> behindWalls(const CandidateNodes<Dim>& nodes, const WallScreen<Dim>& screen) {
    std::vector<unsigned char> behind(nodes.x.size(), 0);
    parallelFor(static_cast<int>(behind.size()), [&](int i) {
        behind[i] = !nodes.onSolid[i] && screen.hides(pointOf<Dim>(nodes, i), reach * nodes.h[i]);
    });
    return behind;
}

}  // namespace

template <int Dim>
std::vector<int> cutByWalls(const CandidateNodes<Dim>& nodes, const MovedMesh<Dim>& moved,
                            const Triangulation<Dim>& triangulation, const std::vector<int>& asked) {
    const WallScreen<Dim> screen(moved.topology, moved.x);
    const auto behind = behindWalls<Dim>(nodes, screen);
    if (std::count(behind.begin(), behind.end(), 1) == 0) return {};
    const auto isParted = [&](int from, int to) {
        const double h = 0.5 * (nodes.h[from] + nodes.h[to]);
        return screen.parts(pointOf<Dim>(nodes, from), pointOf<Dim>(nodes, to), slack * h,
                            WallScreen<Dim>::shortDetour * h);
    };
    const auto isCut = [&](const Simplex<Dim>& cell) {
        for (const int to : cell)
            for (const int from : cell)
                if (behind[to] && from != to && isParted(from, to)) return true;
        return false;
    };
    const auto found =
        parallelChosen(static_cast<int>(asked.size()), [&](int k) { return isCut(triangulation.cells[asked[k]]); });
    std::vector<int> cut;
    for (const int k : found) cut.push_back(asked[k]);
    return cut;
}

#define PFEM_INSTANTIATE(D)                                                                                         \
    template std::vector<int> cutByWalls<D>(const CandidateNodes<D>&, const MovedMesh<D>&, const Triangulation<D>&, \
                                            const std::vector<int>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
