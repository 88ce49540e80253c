#include "bounds/runTwin.hpp"

#include <fmt/format.h>

#include <ostream>

#include "application/runProgram.hpp"
#include "base/error.hpp"
#include "case/interrupt.hpp"

namespace pfem {

namespace {

void runIn(const TwinCase& twin, const std::vector<std::string>& command, std::ostream& out) {
    const auto log = twin.root / ("log." + std::filesystem::path(command[0]).filename().string());
    int seconds = 0;
    const int code = runProgram(command, twin.root, log, [&] {
        if (++seconds % 15 == 0) out << "    " << lastLineWith(log, "Progress") << "\n" << std::flush;
    });
    if (interrupted()) throw UserError("stopped; the same command goes on from here");
    if (code != 0)
        throw UserError(fmt::format("{} has failed with exit code {}: see \"{}\"", command[0], code, log.string()));
}

}  // namespace

void runTwin(const TwinCase& twin, std::ostream& out) {
    const auto before = reachedTime(twin.root);
    if (before.finished()) {
        out << fmt::format("{}: finished\n", twin.name()) << std::flush;
        return;
    }
    out << fmt::format("{}: from {} to {} s\n", twin.name(), before.latest.value_or(0), before.endTime) << std::flush;
    if (!before.latest) runIn(twin, {siblingProgram("pfemMesh"), "-h", fmt::format("{}", twin.h)}, out);
    runIn(twin, {siblingProgram("pfemFsiFoam")}, out);
    if (!reachedTime(twin.root).finished())
        throw UserError(fmt::format("{} has not reached its endTime: see its log", twin.name()));
}

}  // namespace pfem
