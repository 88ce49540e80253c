#include "bounds/runTwin.hpp"

#include <fmt/format.h>

#include "study/runCase.hpp"
#include "study/runProgram.hpp"

namespace pfem {

void runTwin(const TwinCase& twin, std::ostream& out) {
    runCase(twin.root, twin.name(),
            {.mesh = {siblingProgram("pfemMesh"), "-h", fmt::format("{}", twin.h)},
             .solve = {siblingProgram("pfemFsiFoam")}},
            out);
}

}  // namespace pfem
