#include "study/runCase.hpp"

#include <fmt/format.h>

#include <ostream>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "case/interrupt.hpp"
#include "case/timeFolders.hpp"
#include "dictionary/dictionary.hpp"
#include "io/history.hpp"
#include "study/runProgram.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

fs::path markOf(const fs::path& root) { return root / ".pfemUnfinished"; }

/// The program that a command runs: of a shell's text the first word that sets no variable.
std::string programOf(const Command& command) {
    if (command.size() < 3 || command[1] != "-c") return fs::path(command[0]).filename().string();
    for (const auto& word : wordsOf(command[2]))
        if (word.find('=') == std::string::npos) return fs::path(word).filename().string();
    return "command";
}

void runIn(const fs::path& root, const Command& command, const StudyCommands& commands, std::ostream& out) {
    const auto log = root / ("log." + programOf(command));
    int seconds = 0;
    const int code = runProgram(command, root, log, [&] {
        if (++seconds % 15 == 0) out << "    " << lastLineWith(log, "Progress") << "\n" << std::flush;
        if (commands.tick) commands.tick();
    });
    if (interrupted()) throw UserError("stopped; the same command goes on from here");
    if (code != 0)
        throw UserError(
            fmt::format("{} has failed with exit code {}: see \"{}\"", programOf(command), code, log.string()));
}

}  // namespace

bool Reached::finished() const { return !unfinished && latest && *latest >= endTime * (1 - 1e-9); }

Reached reachedTime(const fs::path& root) {
    Reached reached;
    reached.endTime = Dictionary::read(root / "system" / "controlDict").get<double>("endTime");
    reached.unfinished = fs::exists(markOf(root));
    const auto times = listTimes(root).complete;
    if (!times.empty()) reached.latest = times.back().value;
    return reached;
}

Command shellCommand(const std::string& text) { return {"sh", "-c", text}; }

void runCase(const fs::path& root, const std::string& name, const StudyCommands& commands, std::ostream& out) {
    const auto before = reachedTime(root);
    if (before.finished()) {
        out << fmt::format("{}: finished\n", name) << std::flush;
        return;
    }
    out << fmt::format("{}: from {} to {} s\n", name, before.latest.value_or(0), before.endTime) << std::flush;
    writeAtomically(markOf(root), "The commands of the study have not come to their end.\n");
    if (!before.latest) runIn(root, commands.mesh, commands, out);
    runIn(root, commands.solve, commands, out);
    fs::remove(markOf(root));
    if (!reachedTime(root).finished())
        throw UserError(fmt::format("{} has not reached its endTime: see its log", name));
}

}  // namespace pfem
