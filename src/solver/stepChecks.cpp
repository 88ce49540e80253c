#include "solver/stepChecks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace pfem {

template <int Dim>
bool collapses(const FluidPhase<Dim>& phase, const Points<Dim>& x) {
    const SmoothingDomains<Dim>& fluid = phase.domains;
    const auto collapsing = [&](int e) {
        return sliverFactor<Dim>(fluid.element[e]) == 1 &&
               simplexMeasure<Dim>(x, fluid.cell(e)) < 0.2 * fluid.element[e].measure;
    };
    return fluid.share.firstCell(fluid.nCells(), collapsing) < fluid.nCells();
}

template <int Dim>
void checkDomains(const FluidPhase<Dim>& fluidPhase, const SolidPhase<Dim>& solidPhase, const Nodes<Dim>& nodes) {
    const auto& [fluid, solid] = std::tie(fluidPhase.domains, solidPhase.domains);
    const auto place = [&](const Vec<Dim>& x) { return placeText<Dim>(x); };
    for (int e = 0; e < solid.nCells(); ++e)
        if (!(solid.element[e].measure > 0))
            throw StepFailure("solid element inverted at " + place(simplexCentroid<Dim>(nodes.x, solid.cell(e))),
                              idsOf<Dim>(nodes, solid.cell(e)));
    const auto inverted = [&, &domains = fluid](int i) {
        return domains.around->count(i) > 0 && !(domains.volume[i] > 0);
    };
    const int i = fluid.share.firstNode(fluid.nNodes(), inverted);
    if (i < fluid.nNodes())
        throw StepFailure(fmt::format("fluid patch of node {} inverted at {}", nodes.id[i], place(nodes.x[i])),
                          {nodes.id[i]});
}

template <int Dim>
StepFailure notConverged(const StepReport& report, const std::vector<double>& dp, const Nodes<Dim>& nodes,
                         const SmoothingDomains<Dim>& fluid) {
    const NodeToCells& around = *fluid.around;
    const auto text = fmt::format("no convergence in {} iterations: |dv|/|v| = {:.3g}, |dp|/|p| = {:.3g}",
                                  report.iterations, report.finalU, report.finalP);
    const auto worst =
        std::max_element(dp.begin(), dp.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (worst == dp.end() || *worst == 0) return StepFailure(text);
    const int i = static_cast<int>(worst - dp.begin());
    std::vector<double> least(nodes.size(), std::numeric_limits<double>::max());  // whose rank sees the cells
    for (int s = around.start[i]; s < around.start[i + 1]; ++s)
        least[i] = std::min(least[i], fluid.element[around.cell[s]].measure);
    fluid.share.gather(least);
    return StepFailure(
        text + fmt::format("; worst at {}, node {} with {} {}, smallest {:.3g} h^{}", placeText<Dim>(nodes.x[i]),
                           nodes.id[i], around.count(i), Dim == 2 ? "triangles" : "tetrahedra",
                           least[i] / std::pow(nodes.h[i], Dim), Dim),
        {nodes.id[i]});
}

#define PFEM_INSTANTIATE(D)                                                                              \
    template bool collapses<D>(const FluidPhase<D>&, const Points<D>&);                                  \
    template void checkDomains<D>(const FluidPhase<D>&, const SolidPhase<D>&, const Nodes<D>&);          \
    template StepFailure notConverged<D>(const StepReport&, const std::vector<double>&, const Nodes<D>&, \
                                         const SmoothingDomains<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
