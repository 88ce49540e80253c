// The edge of a solid over which fluid slides, with friction where it is given.

#include "conditions/frictionEntry.hpp"

namespace pfem {

PatchType slipInterfacePatch() {
    return {.name = "slipInterface",
            .meaning = "free; fluid slides over the solid (elsewhere it sticks to it)",
            .kind = PatchKind::skin,
            .onlyOfSolids = true,
            .wet = Constraint::slide,
            .contactLine = Constraint::slide,
            .entries = {frictionEntry()},
            .read = readFriction};
}

}  // namespace pfem
