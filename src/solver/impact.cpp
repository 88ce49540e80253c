#include "solver/impact.hpp"

#include <algorithm>

#include "mesh/adjacency.hpp"
#include "mesh/simplex.hpp"
#include "momentum/boundaryConditions.hpp"
#include "momentum/mass.hpp"

namespace pfem {

namespace {

constexpr int mostTurns = 20;
constexpr double enough = 0.01;  // of the fastest closing

/// How patches and walls hold the nodes where they are. The contact line of a no-slip wall, which may creep, takes no impulse either.
template <int Dim>
NodeConstraints<Dim> holdOf(const Problem<Dim>& problem, const State<Dim>& state) {
    const auto topology = makeTopology<Dim>(state.mesh, problem.conditions.kind, state.nodes.wall);
    const double now = state.time.value;
    auto c = nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes, now, now);
    for (int i = 0; i < state.nodes.size(); ++i)
        if (topology.onWall[i] && problem.conditions.kind[topology.walls[state.nodes.wall[i]].patch] == PatchKind::noSlipWall)
            c.hold[i] = Hold::fixed;
    return c;
}

/// The contacts without nodes of solids.
template <int Dim>
std::vector<Simplex<Dim>> betweenFluids(const std::vector<Simplex<Dim>>& contacts, const State<Dim>& state) {
    const auto ofSolid = nodesIn<Dim>(state.mesh.solid.nodes, state.nodes.size());
    std::vector<Simplex<Dim>> result;
    for (const auto& s : contacts)
        if (std::none_of(s.begin(), s.end(), [&](int i) { return ofSolid[i]; })) result.push_back(s);
    return result;
}

}  // namespace

template <int Dim>
void strike(const Problem<Dim>& problem, const std::vector<Simplex<Dim>>& contacts, State<Dim>& state) {
    auto& v = state.nodes.v;
    const auto struck = betweenFluids<Dim>(contacts, state);
    double fastest = 0;
    for (const auto& s : struck) fastest = std::max(fastest, -simplexDivergence<Dim>(state.nodes.x, v, s));
    if (fastest == 0) return;
    const auto constraints = holdOf<Dim>(problem, state);
    const auto mass = fluidMass<Dim>(problem, state.mesh.fluid, state.nodes.x);
    bool closing = true;
    for (int turn = 0; closing && turn < mostTurns; ++turn) {
        closing = false;
        for (const auto& s : struck) {
            const auto g = simplexGeometry<Dim>(state.nodes.x, s);
            double div = 0, mobility = 0;
            std::array<Vec<Dim>, Dim + 1> change;  // by an impulse of 1
            for (int k = 0; k <= Dim; ++k) {
                change[k] = constraints.project(s[k], g.gradN[k]) / mass[s[k]];
                div += v[s[k]].dot(g.gradN[k]);
                mobility += change[k].dot(g.gradN[k]);
            }
            if (div >= -enough * fastest || !(mobility > 0)) continue;
            closing = true;
            for (int k = 0; k <= Dim; ++k) v[s[k]] -= div / mobility * change[k];
        }
    }
}

template void strike<2>(const Problem<2>&, const std::vector<Simplex<2>>&, State<2>&);

}  // namespace pfem
