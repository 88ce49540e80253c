#include "solver/checkOpenings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "conditions/inflow.hpp"
#include "mesh/onFace.hpp"

namespace pfem {

namespace {

/// How far from a place of an inlet, in the direction of its water, the first wall is, and its patch.
struct Obstacle {
    double distance;
    int patch;
};

template <int Dim>
Obstacle inFrontOf(const Topology<Dim>& topology, const Points<Dim>& points, const Vec<Dim>& place,
                   const Vec<Dim>& direction) {
    Obstacle nearest{1e300, -1};
    for (const auto& wall : topology.walls) {
        if (wall.patch < 0 || topology.kinds[wall.patch] == PatchKind::opening) continue;
        const Vec<Dim> n = inwardNormal<Dim>(points, wall.nodes);
        const double approach = -n.dot(direction), distance = n.dot(place - points[wall.nodes[0]]) / approach;
        if (!(approach > 0.5) || distance < 0 || distance >= nearest.distance) continue;
        if (footWeights<Dim>(points, wall.nodes, place + distance * direction).minCoeff() >= 0)
            nearest = {distance, wall.patch};
    }
    return nearest;
}

template <int Dim>
void checkLevels(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state) {
    const Vec<Dim> gravity = problem.gravityOutside();
    const double g = gravity.norm();
    for (std::size_t k = 0; k < problem.conditions.outlet.size(); ++k) {
        const auto& outlet = problem.conditions.outlet[k];
        if (!outlet || !outlet->level || g == 0) continue;
        double low = 1e300;  // of the patch, against gravity
        for (const auto& face : state.mesh.patches[k].faces)
            for (const int node : face) low = std::min(low, -gravity.dot(state.nodes.x[node]) / g);
        const double level = outlet->level->value(state.time.value);
        if (!outlet->level->isConstant() || level > low) continue;
        const auto& name = state.mesh.patches[k].name;
        dict.subDict(name).fatal(
            "level", fmt::format("the level of {:g} m is below the outlet '{}', whose lower end is at {:g} m: an "
                                 "outlet without level lets water fall freely",
                                 level, name, low + 0.0));  // no -0
    }
}

}  // namespace

template <int Dim>
void checkOpenings(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state) {
    const auto& conditions = problem.conditions;
    checkLevels<Dim>(dict, problem, state);
    if (!conditions.anyInlet()) return;
    const auto& nodes = state.nodes;
    const auto topology = makeTopology<Dim>(state.mesh, conditions.kind, nodes.x, nodes.wall);
    const bool open = topology.faces.empty() || conditions.anyOutlet() ||
                      std::any_of(topology.faces.begin(), topology.faces.end(),
                                  [](const auto& face) { return face.kind == FaceKind::freeSurface; });
    for (std::size_t k = 0; k < conditions.inlet.size(); ++k) {
        if (!conditions.inlet[k]) continue;
        const auto& patch = state.mesh.patches[k];
        const Dictionary& entry = dict.subDict(patch.name);
        if (!open)
            entry.fatal("type", "'" + patch.name +
                                    "' is an inlet, but the fluid has neither a free surface nor an outlet: no more "
                                    "water can come into a closed box");
        const double h = nodes.h[patch.faces.at(0)[0]];
        const auto spread = inletSpread<Dim>(*conditions.inlet[k], patch.faces, nodes.x, state.time.value);
        for (const auto& face : patch.faces) {
            Vec<Dim> middle = Vec<Dim>::Zero();
            for (const int node : face) middle += nodes.x[node] / Dim;
            const Obstacle wall = inFrontOf<Dim>(topology, nodes.x, middle, spread.direction);
            if (wall.patch >= 0 && wall.distance < 2 * h)
                entry.fatal("type", fmt::format("the water of the inlet '{}' comes against the wall '{}', {:.3g} m in "
                                                "front of it, less than two mesh sizes",
                                                patch.name, state.mesh.patches[wall.patch].name, wall.distance));
        }
        bool wet = Dim == 2;
        for (int i = 0; !wet && i < topology.nNodes(); ++i)
            wet = topology.wet(i) && inletOf<Dim>(conditions, topology, i) == static_cast<int>(k);
        if (!wet)
            entry.fatal("type", "no water wets the inlet '" + patch.name +
                                    "': in space a jet needs a body of fluid in its nozzle to begin with");
    }
}

#define PFEM_INSTANTIATE(D) template void checkOpenings<D>(const Dictionary&, const Problem<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
