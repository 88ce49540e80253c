#include "remesh/cavities.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// A cell that is in one of both meshes alone.
template <int Dim>
struct Piece {
    Simplex<Dim> nodes;  // ascending; of those that have gone -1 - (old index): they join old cells alone
    double gain;         // its measure, negative of an old cell
};

/// Of a cell and its copies beyond periodic sides one counts.
template <int Dim>
bool counts(const Images<Dim>& images, const Simplex<Dim>& cell) {
    const int lowest =
        *std::min_element(cell.begin(), cell.end(), [&](int i, int j) { return images.own(i) < images.own(j); });
    return !images.isImage(lowest);
}

template <int Dim>
std::vector<Piece<Dim>> piecesOf(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex,
                                 const CellChanges<Dim>& selected) {
    std::vector<Piece<Dim>> pieces;
    pieces.reserve(selected.vanished.size() + selected.fresh.size());
    const auto add = [&](Simplex<Dim> nodes, double gain) {
        std::sort(nodes.begin(), nodes.end());
        pieces.push_back({nodes, gain});
    };
    for (const int e : selected.vanished) {
        auto cell = moved.fluid[e];
        if (!counts<Dim>(moved.images, cell)) continue;
        const double measure = simplexMeasure<Dim>(moved.x, cell);
        for (int& node : cell) {
            const int own = moved.images.own(node);
            node = newIndex[own] < 0 ? -1 - own : newIndex[own];
        }
        add(cell, -measure);
    }
    for (const auto& fresh : selected.fresh) add(fresh.cell, fresh.amount);
    return pieces;
}

/// Of each piece the first of those that hang together by faces.
template <int Dim>
std::vector<int> joinedByFaces(const std::vector<Piece<Dim>>& pieces) {
    const int n = static_cast<int>(pieces.size());
    std::vector<std::pair<Face<Dim>, int>> sides;
    sides.reserve(pieces.size() * (Dim + 1));
    for (int p = 0; p < n; ++p)
        for (int corner = 0; corner <= Dim; ++corner) {
            Face<Dim> face;
            for (int k = 0; k < Dim; ++k) face[k] = pieces[p].nodes[k < corner ? k : k + 1];
            sides.emplace_back(face, p);
        }
    std::sort(sides.begin(), sides.end());
    std::vector<int> first(n);
    std::iota(first.begin(), first.end(), 0);
    const auto find = [&](int p) {
        while (first[p] != p) p = first[p] = first[first[p]];
        return p;
    };
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
        if (sides[k].first != sides[k + 1].first) continue;
        const int a = find(sides[k].second), b = find(sides[k + 1].second);
        first[std::max(a, b)] = std::min(a, b);
    }
    for (int p = 0; p < n; ++p) first[p] = find(p);
    return first;
}

}  // namespace

template <int Dim>
std::vector<Cavity<Dim>> cavities(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex,
                                  const CellChanges<Dim>& selected) {
    const auto pieces = piecesOf<Dim>(moved, newIndex, selected);
    const auto first = joinedByFaces<Dim>(pieces);
    std::vector<int> number(pieces.size());
    std::vector<Cavity<Dim>> result;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (first[p] == static_cast<int>(p)) {
            number[p] = static_cast<int>(result.size());
            result.emplace_back();
        }
        auto& cavity = result[number[first[p]]];
        cavity.gain += pieces[p].gain;
        for (const int node : pieces[p].nodes)
            if (node >= 0) cavity.nodes.push_back(node);
    }
    for (auto& cavity : result) {
        std::sort(cavity.nodes.begin(), cavity.nodes.end());
        cavity.nodes.erase(std::unique(cavity.nodes.begin(), cavity.nodes.end()), cavity.nodes.end());
    }
    return result;
}

#define PFEM_INSTANTIATE(D)                                                                   \
    template std::vector<Cavity<D>> cavities<D>(const MovedMesh<D>&, const std::vector<int>&, \
                                                const CellChanges<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
