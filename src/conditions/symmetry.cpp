// A plane that cuts a body: its nodes slide along it.

#include "conditions/patchType.hpp"

namespace pfem {

PatchType symmetryPatch() {
    return {.name = "symmetry",
            .meaning = "they slide along the patch",
            .kind = PatchKind::symmetry,
            .own = Constraint::slide};
}

}  // namespace pfem
