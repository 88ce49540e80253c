#pragma once
// The solids of a case.

#include "conditions/problem.hpp"
#include "momentum/controls.hpp"

namespace pfem {

/// What is known of the solids before they move; a view.
template <int Dim>
struct Solids {
    const Problem<Dim>& problem;
    const SolidControls& controls;
    const Cells<Dim>& cells;
};

}  // namespace pfem
