#pragma once
// How much fluid there is: the one definition that the solver's ledger and the mass functions share.

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "state/images.hpp"

namespace pfem {

/// Sum of the cells' measures, inverted ones negative: what moves only inside changes nothing [m2 (2D), m3].
template <int Dim>
double cellVolume(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells) {
    return parallelSum(static_cast<int>(cells.size()), [&](int e) { return simplexMeasure<Dim>(x, cells[e]); });
}

/// Of the cells that count (state/images.hpp).
template <int Dim>
double cellVolume(const State<Dim>& state) {
    return parallelSum(nOwnCells<Dim>(state),
                       [&](int e) { return simplexMeasure<Dim>(state.nodes.x, state.mesh.fluid.nodes[e]); });
}

/// What isolated particles carry.
template <int Dim>
double dropVolume(const State<Dim>& state) {
    double volume = 0;
    const int n = nOwnNodes<Dim>(state);
    for (int i = 0; i < n; ++i) volume += state.nodes.dropVolume[i];
    return volume;
}

/// Volume of the fluid's cells plus what isolated particles carry.
template <int Dim>
double totalVolume(const State<Dim>& state) {
    return cellVolume<Dim>(state) + dropVolume<Dim>(state);
}

}  // namespace pfem
