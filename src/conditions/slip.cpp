// A rigid wall along which fluid slides, with friction where it is given.

#include "conditions/frictionEntry.hpp"

namespace pfem {

PatchType slipPatch() {
    return {.name = "slip",
            .meaning = "fluid slides along the wall",
            .kind = PatchKind::wall,
            .mayMove = true,
            .wet = Constraint::slide,
            .contactLine = Constraint::slide,
            .entries = {frictionEntry()},
            .read = readFriction};
}

}  // namespace pfem
