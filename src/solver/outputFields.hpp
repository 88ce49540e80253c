#pragma once
// Fields for the eye that are written beside the state.

#include "io/stateFiles.hpp"
#include "state/problem.hpp"

namespace pfem {

/// freeSurface (1 on free-surface nodes).
template <int Dim>
ExtraFields outputFields(const Problem<Dim>& problem, const State<Dim>& state) {
    ExtraFields extra;
    extra.nodalFlags["freeSurface"] =
        makeTopology<Dim>(state.mesh, problem.conditions.kind, state.nodes.wall).freeSurface;
    return extra;
}

}  // namespace pfem
