#pragma once
// Fluid that slides over a solid has nodes of its own there.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Where fluid shares nodes with a solid under a skin, it gets copies of them, with the skin's faces (and those of the
/// walls there) as supports; the faces of skins are turned so that the fluid is on their left. A state that is such
/// already stays as it is. `kinds`: of the patches.
template <int Dim>
void separateFromSkins(const std::vector<PatchKind>& kinds, State<Dim>& state);

}  // namespace pfem
