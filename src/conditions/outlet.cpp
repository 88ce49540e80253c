// Where water leaves for good.

#include "conditions/patchType.hpp"

namespace pfem {

PatchType outletPatch() {
    return {.name = "outlet",
            .meaning = "water leaves",
            .kind = PatchKind::opening,
            .entries = {{"pressure", "scalar of time", "Pa", "none",
                         "of an outlet: that of what is outside; water goes straight through", ""},
                        {"level", "scalar of time", "m", "none",
                         "of an outlet: of still water outside, measured against gravity from the origin, instead of "
                         "pressure; "
                         "water goes straight through",
                         ""},
                        {"waveSpeed", "scalar", "m/s", "none",
                         "of an outlet with a level: waves of this phase velocity go out over it and do not come back",
                         "> 0"}},
            .read = [](const Dictionary& entry, bool) {
                auto outlet = std::make_shared<Outlet>();
                if (entry.found("pressure") && entry.found("level"))
                    entry.fatal("level", "Give either pressure or level, not both");
                if (entry.found("pressure")) outlet->pressure = readFunction1<double>(entry, "pressure");
                if (entry.found("level")) outlet->level = readFunction1<double>(entry, "level");
                outlet->waveSpeed = entry.get("waveSpeed", outlet->waveSpeed);
                if (entry.found("waveSpeed") && !outlet->level)
                    entry.fatal("waveSpeed", "waves go out over water with a level: give 'level', too");
                if (entry.found("waveSpeed") && !(outlet->waveSpeed > 0))
                    entry.fatal("waveSpeed", "Entry 'waveSpeed' must be positive");
                PatchEntries e;
                e.outlet = outlet;
                return e;
            }};
}

}  // namespace pfem
