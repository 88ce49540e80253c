#include "solver/checkPeriodic.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "conditions/sides.hpp"

namespace pfem {

namespace {

/// Do nodes of solids come near to the sides of direction k?
template <int Dim>
bool solidsAt(const Period<Dim>& period, int k, double width, const State<Dim>& state) {
    const double from = period.from[k] + width, to = period.from[k] + period.length[k] - width;
    for (const auto& cell : state.mesh.solid.nodes)
        for (const int i : cell)
            if (state.nodes.x[i][k] < from || state.nodes.x[i][k] > to) return true;
    return false;
}

/// The patch of a wall that holds images beyond its end; -1: none.
template <int Dim>
int endingWall(const Sides<Dim>& sides, const State<Dim>& unfolded) {
    const auto& nodes = unfolded.nodes;
    for (int i = nOwnNodes<Dim>(unfolded); i < nodes.size(); ++i)
        for (const int wall : nodes.wall[i])
            if (wall >= 0 && placeOnRegion<Dim>(sides.walls, sides.points, wall, nodes.x[i]).beyond >= 0)
                return sides.walls[wall].patch;
    return -1;
}

}  // namespace

template <int Dim>
void checkPeriodic(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state) {
    const Period<Dim>& period = problem.period;
    if (!period.any()) {
        if (nOwnNodes<Dim>(state) < state.nodes.size())
            throw UserError("the time folder was written with periodic sides, but there is no file constant/periodic");
        return;
    }
    double h = 0;
    for (const double size : state.nodes.h) h = std::max(h, size);
    const double width = bandWidth * h;
    for (int k = 0; k < Dim; ++k) {
        const std::string name(1, "xyz"[k]);
        if (period.length[k] == 0) continue;
        if (period.length[k] < 2 * width)
            dict.fatal(name, fmt::format("the sides must be at least {:.4g} m apart, {} mesh sizes", 2 * width,
                                         2 * bandWidth));
        if (problem.conditions.anyInlet() || problem.conditions.anyOutlet())
            dict.fatal(name, "periodic sides together with inlets or outlets are not implemented");
        if (solidsAt<Dim>(period, k, width, state))
            dict.fatal(name,
                       fmt::format("solids must keep {:.4g} m from periodic sides, {} mesh sizes", width, bandWidth));
    }
    const auto sides = sidesOf<Dim>(problem, state);
    const int patch = endingWall<Dim>(sides, unfolded<Dim>(sides, state));
    if (patch >= 0)
        throw UserError(
            fmt::format(
                "the wall '{}' ends at a periodic side: draw it on beyond both sides by at least {:.4g} m, {} mesh "
                "sizes",
                state.mesh.patches[patch].name, width, bandWidth),
            dict.where());
}

#define PFEM_INSTANTIATE(D) template void checkPeriodic<D>(const Dictionary&, const Problem<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
