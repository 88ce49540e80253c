// A rigid wall to which fluid sticks. The contact line creeps on, else it could not move.

#include "conditions/patchType.hpp"

namespace pfem {

PatchType noSlipPatch() {
    return {.name = "noSlip",
            .meaning = "it sticks",
            .kind = PatchKind::wall,
            .mayMove = true,
            .wet = Constraint::fixed,
            .contactLine = Constraint::slide};
}

}  // namespace pfem
