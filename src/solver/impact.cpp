#include "solver/impact.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/simplex.hpp"
#include "momentum/boundaryConditions.hpp"
#include "remesh/heirs.hpp"

namespace pfem {

namespace {

constexpr int mostTurns = 20;
constexpr double enough = 0.01;  // of the fastest closing

/// How patches and walls hold the nodes. What is on a no-slip wall takes no impulse, the contact line, which may creep, included.
template <int Dim>
NodeConstraints<Dim> holdOf(const std::vector<PatchKind>& kinds, const State<Dim>& state) {
    const auto& nodes = state.nodes;
    NodeConstraints<Dim> c;
    c.hold.assign(nodes.size(), Hold::free);
    c.normal.assign(nodes.size(), Vec<Dim>::Zero());
    const auto slide = [&](int i, const Vec<Dim>& area) {
        c.hold[i] = Hold::slide;
        c.normal[i] = area.normalized();
    };
    std::vector<std::pair<PatchKind, Face<Dim>>> faces;
    for (std::size_t k = 0; k < kinds.size(); ++k)
        for (const auto& face : state.mesh.patches[k].faces) {
            faces.emplace_back(kinds[k], face);
            for (int i : face) {
                if (kinds[k] != PatchKind::symmetry) continue;
                const Vec<Dim> n = faceArea<Dim>(nodes.X, face).normalized();
                if (c.hold[i] == Hold::free) slide(i, n);
                else if (c.normal[i].dot(n) < std::cos(20 * M_PI / 180)) c.hold[i] = Hold::fixed;  // two planes
            }
        }
    for (int i = 0; i < nodes.size(); ++i) {
        if (nodes.wall[i] < 0) continue;
        const auto& [kind, face] = faces[nodes.wall[i]];
        slide(i, faceArea<Dim>(nodes.x, face));
        if (kind == PatchKind::noSlipWall) c.hold[i] = Hold::fixed;
    }
    for (const auto& [kind, face] : faces)
        for (int i : face)
            if (isWall(kind)) c.hold[i] = Hold::fixed;
    return c;
}

/// Of the fluid around the nodes.
template <int Dim>
std::vector<double> massOf(const Problem<Dim>& problem, const State<Dim>& state) {
    std::vector<double> mass(state.nodes.size(), 0.0);
    const auto& fluid = state.mesh.fluid;
    for (int e = 0; e < fluid.size(); ++e) {
        const double share = problem.fluid(fluid.material[e]).rho * simplexMeasure<Dim>(state.nodes.x, fluid.nodes[e]) / (Dim + 1);
        for (int node : fluid.nodes[e]) mass[node] += share;
    }
    return mass;
}

/// The contacts without nodes of solids.
template <int Dim>
std::vector<Simplex<Dim>> betweenFluids(const std::vector<Simplex<Dim>>& contacts, const State<Dim>& state) {
    const auto ofSolid = wetNodes<Dim>(state.mesh.solid.nodes, state.nodes.size());
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
    const auto constraints = holdOf<Dim>(problem.conditions.kind, state);
    const auto mass = massOf<Dim>(problem, state);
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
