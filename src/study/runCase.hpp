#pragma once
// The computation of a case of a study: from where it is to its end, by child processes in its folder.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace pfem {

/// The latest complete time of a case and the end of its run [s].
struct Reached {
    std::optional<double> latest;
    double endTime = 0;
    bool unfinished = false;  // the commands of a study have begun and not come to their end
    bool finished() const;
};
Reached reachedTime(const std::filesystem::path& root);

using Command = std::vector<std::string>;

/// What brings a case to its end.
struct StudyCommands {
    Command mesh;                     // for a case without a time folder
    Command solve;                    // for every case that is not finished
    std::function<void()> tick = {};  // called about once a second
};

/// The words that have the shell run `text`.
Command shellCommand(const std::string& text);

/// Run the case to its endTime, from where it is; a finished one is left alone. The output of a command goes to
/// log.<program> in its folder; every 15 s the progress that it tells goes to `out`. A case is finished when its last
/// time is endTime and the commands have ended without an error. Throws UserError, also when SIGINT or SIGTERM stopped
/// it.
void runCase(const std::filesystem::path& root, const std::string& name, const StudyCommands& commands,
             std::ostream& out);

}  // namespace pfem
