// A loaded edge of a solid.

#include "conditions/patchType.hpp"

namespace pfem {

PatchType tractionPatch() {
    return {.name = "traction",
            .meaning = "a loaded edge of a solid",
            .kind = PatchKind::edge,
            .onlyOfSolids = true,
            .loads = true,
            .entries = {{"traction", "vector of time", "Pa", "required for traction", "load per area", ""}},
            .read = [](const Dictionary& entry, bool plane) {
                PatchEntries e;
                e.traction =
                    plane ? readPlaneFunction1(entry, "traction") : readFunction1<Eigen::Vector3d>(entry, "traction");
                return e;
            }};
}

}  // namespace pfem
