#pragma once
// The entry `friction` of what water slides along.

#include "conditions/patchType.hpp"

namespace pfem {

inline EntryDescription frictionEntry() {
    return {"friction",
            "scalar",
            "-",
            "0",
            "of slip and slipInterface: shear stress rho c_f |u| u / 2; smooth walls 0.079 Re^(-1/4), Re with 4 times "
            "the depth",
            ">= 0"};
}

inline PatchEntries readFriction(const Dictionary& entry, bool) {
    PatchEntries e;
    e.friction = entry.get<double>("friction", 0);
    if (!(e.friction >= 0)) entry.fatal("friction", "Entry 'friction' must not be negative");
    return e;
}

}  // namespace pfem
