#pragma once
// Fields by name, as probes and other functions ask for them.

#include <functional>
#include <string>
#include <vector>

#include "state/state.hpp"

namespace pfem {

/// Where a field has a meaning.
enum class Region { fluid, solid, both };

/// A nodal field: its components in the order of OpenFOAM's text files (symmetric tensors xx xy xz yy yz zz).
template <int Dim>
struct NodalField {
    std::string name;
    int components = 1;  // 1, 3 (vectors also in 2D), 6
    Region region = Region::both;
    std::vector<double> (*value)(const Nodes<Dim>& nodes, int i) = nullptr;
};

/// U a D p sigma h. Throws UserError with the valid list.
template <int Dim>
const NodalField<Dim>& nodalField(const std::string& name);

}  // namespace pfem
