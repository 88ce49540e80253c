#include "remesh/motionAccount.hpp"

#include "state/volume.hpp"

namespace pfem {

template <int Dim>
MotionAccount<Dim>::MotionAccount(const State<Dim>& state, const Ranks& ranks) : ranks_(ranks), volume_(volume(state)) {
    if (state.ledger.counting()) x_ = state.nodes.x;
}

/// As cellVolume.
template <int Dim>
double MotionAccount<Dim>::volume(const State<Dim>& state) const {
    if (ranks_.isAlone()) return cellVolume<Dim>(state);
    return ranks_.sum(nOwnCells<Dim>(state),
                      [&](int e) { return simplexMeasure<Dim>(state.nodes.x, state.mesh.fluid.nodes[e]); });
}

template <int Dim>
void MotionAccount<Dim>::book(VolumeCause cause, State<Dim>& state) {
    state.ledger.book(cause, change(cause, state));
}

template <int Dim>
void MotionAccount<Dim>::bookSolver(const std::vector<double>& returned, const std::vector<double>& compressed,
                                    State<Dim>& state) {
    VolumeLedger& ledger = state.ledger;
    const double correction = ledger.book(VolumeCause::correction, returned),
                 compression = ledger.book(VolumeCause::compression, compressed);
    ledger.place(VolumeCause::solver, returned, -1);
    ledger.place(VolumeCause::solver, compressed, -1);
    ledger.book(VolumeCause::solver, change(VolumeCause::solver, state) - correction - compression);
}

template <int Dim>
double MotionAccount<Dim>::change(VolumeCause cause, State<Dim>& state) {
    const auto& cells = state.mesh.fluid.nodes;
    const double before = volume_;
    volume_ = volume(state);
    if (x_.empty()) return volume_ - before;
    for (int e = 0; e < nOwnCells<Dim>(state); ++e) {
        const auto& cell = cells[e];
        const double part = (simplexMeasure<Dim>(state.nodes.x, cell) - simplexMeasure<Dim>(x_, cell)) / (Dim + 1);
        for (const int node : cell) state.ledger.place(cause, node, part);
    }
    x_ = state.nodes.x;
    return volume_ - before;
}

#define PFEM_INSTANTIATE(D) template class MotionAccount<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
