#pragma once
// The periodic sides of a problem.

#include "conditions/problem.hpp"
#include "state/unfolding.hpp"

namespace pfem {

/// Empty without periodic sides.
template <int Dim>
Sides<Dim> sidesOf(const Problem<Dim>& problem, const State<Dim>& state) {
    if (!problem.period.any()) return {};
    return {problem.period, wallFaces<Dim>(state.mesh.patches, wallPatches(problem.conditions.kind), state.nodes.x),
            state.nodes.x};
}

}  // namespace pfem
