#include "solver/invariants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "solver/checkPassages.hpp"
#include "solver/failedStep.hpp"
#include "state/volume.hpp"

namespace pfem {

namespace {

template <int Dim>
void checkFinite(const Nodes<Dim>& nodes) {
    const int found = parallelFirst(nodes.size(), [&](int i) {
        return !nodes.x[i].allFinite() || !nodes.v[i].allFinite() || !nodes.a[i].allFinite() ||
               !std::isfinite(nodes.p[i]) || !nodes.sigma[i].allFinite();
    });
    if (found < nodes.size()) failAt<Dim>(nodes, found, "has a value that is not finite");
}

template <int Dim>
void checkCells(const char* kind, const Nodes<Dim>& nodes, const std::vector<Simplex<Dim>>& cells) {
    const int nCells = static_cast<int>(cells.size());
    const int found = parallelFirst(nCells, [&](int e) {
        const double h = nodes.h[cells[e][0]];
        return !(simplexMeasure<Dim>(nodes.x, cells[e]) > -1e-9 * std::pow(h, Dim));  // flat ones are harmless
    });
    if (found == nCells) return;
    const auto& cell = cells[found];
    throw StepFailure(
        fmt::format("{} element with the nodes {} inverted at {}", kind, fmt::join(idsOf<Dim>(nodes, cell), " "),
                    placeText<Dim>(simplexCentroid<Dim>(nodes.x, cell))),
        idsOf<Dim>(nodes, cell));
}

/// The largest change of the volume in a step [m2 (2D), m3]: a part of all that there is. Once water has left through
/// outlets, a few cells may come or go, for the last ones of what runs dry change by much of themselves; but no more
/// than the same part of the run's first volume.
template <int Dim>
double allowedChange(double part, double now, const State<Dim>& state) {
    constexpr double fewCells = 4;
    const double first = now - state.ledger.sum();
    if (state.ledger[VolumeCause::outflow] >= 0 || first <= now) return part * now;
    double largest = 0;
    for (const auto& cell : state.mesh.fluid.nodes)
        largest = std::max(largest, simplexMeasure<Dim>(state.nodes.x, cell));
    return std::max(part * now, std::min(part * first, fewCells * largest));
}

}  // namespace

template <int Dim>
void checkInvariants(const ConvergenceControls& controls, const Topology<Dim>& topology, const State<Dim>& last,
                     const State<Dim>& next) {
    checkFinite<Dim>(next.nodes);
    checkCells<Dim>("solid", next.nodes, next.mesh.solid.nodes);
    checkCells<Dim>("fluid", next.nodes, next.mesh.fluid.nodes);
    checkPassages<Dim>(topology, last, next);
    const double before = totalVolume<Dim>(last), after = totalVolume<Dim>(next) - next.ledger.sum(CauseKind::passage) +
                                                          last.ledger.sum(CauseKind::passage);
    if (std::abs(after - before) > allowedChange<Dim>(controls.maxVolumeChange, before, last))
        throw StepFailure(fmt::format("the fluid's volume changed from {:.6g} to {:.6g} in one step", before, after));
}

template <int Dim>
void checkSpeed(const ConvergenceControls& controls, const Nodes<Dim>& nodes) {
    for (int i = 0; i < nodes.size(); ++i)
        if (!(nodes.v[i].norm() * controls.deltaTMin <= nodes.h[i]))
            failAt<Dim>(nodes, i,
                        fmt::format("moves with {:.3g} m/s: through its mesh size within deltaTMin = {:.3g} s",
                                    nodes.v[i].norm(), controls.deltaTMin));
}

template <int Dim>
double allowedSpeed(const Topology<Dim>& topology, const Nodes<Dim>& nodes) {
    double fastest = 0, pushing = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        fastest = std::max(fastest, nodes.v[i].squaredNorm());
        if (!topology.ofFluid(i) || topology.onOpening(i)) pushing = std::max(pushing, nodes.v[i].squaredNorm());
    }
    return std::sqrt(fastest) + 2 * std::sqrt(pushing);
}

template <int Dim>
void checkSpeedGain(double allowed, const Nodes<Dim>& nodes, Id firstNew) {
    const int found = parallelFirst(
        nodes.size(), [&](int i) { return nodes.id[i] < firstNew && nodes.v[i].norm() > allowed * (1 + 1e-9); });
    if (found < nodes.size())
        failAt<Dim>(
            nodes, found,
            fmt::format("has got {:.6g} m/s from a contact, a landing or remeshing; the fastest before had {:.6g} m/s",
                        nodes.v[found].norm(), allowed));
}

#define PFEM_INSTANTIATE(D)                                                                           \
    template void checkInvariants<D>(const ConvergenceControls&, const Topology<D>&, const State<D>&, \
                                     const State<D>&);                                                \
    template void checkSpeed<D>(const ConvergenceControls&, const Nodes<D>&);                         \
    template double allowedSpeed<D>(const Topology<D>&, const Nodes<D>&);                             \
    template void checkSpeedGain<D>(double, const Nodes<D>&, Id);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
