#include "solver/joinedAtSides.hpp"

#include "conditions/sides.hpp"
#include "remesh/remesh.hpp"

namespace pfem {

namespace {

/// Nodes of the fluid at the upper sides.
template <int Dim>
std::vector<int> atUpperSides(const Period<Dim>& period, const State<Dim>& state) {
    const auto kept = keptNodes<Dim>(state.mesh, state.nodes.size());
    std::vector<int> found;
    for (int i = 0; i < state.nodes.size(); ++i)
        for (int k = 0; k < Dim && !kept[i]; ++k) {
            const double side = period.from[k] + period.length[k];
            if (period.length[k] == 0 || std::abs(state.nodes.x[i][k] - side) > 1e-6 * state.nodes.h[i]) continue;
            found.push_back(i);
            break;
        }
    return found;
}

}  // namespace

template <int Dim>
State<Dim> joinedAtSides(const Problem<Dim>& problem, const RemeshingControls& controls, const State<Dim>& state) {
    const auto twins = atUpperSides<Dim>(problem.period, state);
    if (twins.empty()) return state;
    const auto sides = sidesOf<Dim>(problem, state);
    const auto& kinds = problem.conditions.kind;
    auto joined = unfolded<Dim>(sides, state);
    Triangulator<Dim> triangulator;
    remesh<Dim>({controls,
                 kinds,
                 makeTopology<Dim>(joined.mesh, kinds, joined.nodes.x, joined.nodes.wall),
                 0,
                 twins,
                 {},
                 &sides},
                triangulator, joined);
    joined.ledger = state.ledger;
    if (joined.ledger.counting()) joined.ledger.countFields(joined.nodes.size());
    std::fill(joined.nodes.lostVolume.begin(), joined.nodes.lostVolume.end(), 0.0);
    return folded<Dim>(std::move(joined));
}

#define PFEM_INSTANTIATE(D) \
    template State<D> joinedAtSides<D>(const Problem<D>&, const RemeshingControls&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
