// A rigid wall along which fluid slides, with friction where it is given.

#include "conditions/patchType.hpp"

namespace pfem {

PatchType slipPatch() {
    return {.name = "slip",
            .meaning = "fluid slides along the wall",
            .kind = PatchKind::wall,
            .mayMove = true,
            .wet = Constraint::slide,
            .contactLine = Constraint::slide,
            .entries = {{"friction", "scalar", "-", "0",
                         "of a slip wall: shear stress rho c_f |u| u / 2; smooth walls 0.079 Re^(-1/4), Re with 4 "
                         "times the depth",
                         ">= 0"}},
            .read = [](const Dictionary& entry, bool) {
                PatchEntries e;
                e.friction = entry.get<double>("friction", 0);
                if (!(e.friction >= 0)) entry.fatal("friction", "Entry 'friction' must not be negative");
                return e;
            }};
}

}  // namespace pfem
