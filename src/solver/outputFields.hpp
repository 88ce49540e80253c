#pragma once
// Fields for the eye that are written beside the state.

#include <cctype>

#include "conditions/problem.hpp"
#include "io/stateFiles.hpp"

namespace pfem {

/// Where somebody has asked: the ledger's fields as ledgerSolver, ledgerContact, ...
template <int Dim>
ExtraFields ledgerFields(const State<Dim>& state) {
    ExtraFields extra;
    for (const auto& [cause, amounts] : state.ledger.fields()) {
        std::string name = std::string("ledger") + textOf(cause).name;
        name[6] = static_cast<char>(std::toupper(name[6]));
        extra.ofFluid[name] = amounts;
    }
    return extra;
}

/// freeSurface (1 on free-surface nodes) and the ledger's fields.
template <int Dim>
ExtraFields outputFields(const Problem<Dim>& problem, const State<Dim>& state) {
    ExtraFields extra = ledgerFields<Dim>(state);
    extra.nodalFlags["freeSurface"] =
        makeTopology<Dim>(state.mesh, problem.conditions.kind, state.nodes.x, state.nodes.wall).freeSurface;
    return extra;
}

}  // namespace pfem
