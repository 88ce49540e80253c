// An edge of a solid whose nodes do not move, or as its motion says.

#include "conditions/patchType.hpp"

namespace pfem {

PatchType clampedPatch() {
    return {.name = "clamped",
            .meaning = "the nodes do not move",
            .kind = PatchKind::edge,
            .onlyOfSolids = true,
            .mayMove = true,
            .own = Constraint::fixed};
}

}  // namespace pfem
