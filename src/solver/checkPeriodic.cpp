#include "solver/checkPeriodic.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "conditions/inflow.hpp"
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

/// Throws UserError for an inlet whose water is not the same at both sides, or that has none to begin with.
template <int Dim>
void checkInlets(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& unfolded) {
    const auto& conditions = problem.conditions;
    const auto& nodes = unfolded.nodes;
    const auto topology = makeTopology<Dim>(unfolded.mesh, conditions.kind, nodes.x, nodes.wall);
    const auto images = imagesOf<Dim>(unfolded);
    for (std::size_t k = 0; k < conditions.inlet.size(); ++k) {
        if (!conditions.inlet[k]) continue;
        const auto& patch = unfolded.mesh.patches[k];
        const auto spread = inletSpread<Dim>(*conditions.inlet[k], patch.faces, nodes.x, unfolded.time.value);
        double largest = 0, difference = 0;
        bool wet = false;
        for (int i = 0; i < nodes.size(); ++i) {
            if (!topology.wet(i) || inletOf<Dim>(conditions, topology, i) != static_cast<int>(k)) continue;
            wet = true;
            const double here = spread.speed(nodes.x[i]), there = spread.speed(nodes.x[images.own(i)]);
            largest = std::max({largest, std::abs(here), std::abs(there)});
            difference = std::max(difference, std::abs(here - there));
        }
        if (difference > 1e-6 * largest)
            throw UserError(fmt::format("the profile of the inlet '{}' is not the same at both periodic sides: "
                                        "profile uniform, or an expression that repeats itself",
                                        patch.name),
                            dict.where());
        if (!wet && unfolded.time.index == 0)
            throw UserError(fmt::format("no water wets the inlet '{}': between periodic sides put a body of fluid in "
                                        "front of it",
                                        patch.name),
                            dict.where());
    }
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
        if (solidsAt<Dim>(period, k, width, state))
            dict.fatal(name,
                       fmt::format("solids must keep {:.4g} m from periodic sides, {} mesh sizes", width, bandWidth));
    }
    const auto sides = sidesOf<Dim>(problem, state);
    const auto all = unfolded<Dim>(sides, state);
    const int patch = endingWall<Dim>(sides, all);
    if (patch >= 0)
        throw UserError(
            fmt::format(
                "the wall '{}' ends at a periodic side: draw it on beyond both sides by at least {:.4g} m, {} mesh "
                "sizes",
                state.mesh.patches[patch].name, width, bandWidth),
            dict.where());
    checkInlets<Dim>(dict, problem, all);
}

#define PFEM_INSTANTIATE(D) template void checkPeriodic<D>(const Dictionary&, const Problem<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
