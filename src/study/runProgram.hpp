#pragma once
// Other programs as child processes.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pfem {

/// The program beside the running one, or its bare name (to be found in PATH).
std::string siblingProgram(const std::string& name);

/// Run a program in the folder `place`, its output appended to `log`; wait for its end and that of all that it has
/// started, and meanwhile call `tick` about once a second. They are a process group of their own: a SIGINT or SIGTERM
/// that catchInterrupts() has noted is handed on to all of it once, and when this process is killed the program gets
/// SIGTERM. Returns its exit code, 128 + n after signal n. Throws UserError when it cannot be started.
int runProgram(const std::vector<std::string>& command, const std::filesystem::path& place,
               const std::filesystem::path& log, const std::function<void()>& tick = {});

/// The last line of a log that begins with `word`, looked for in its last 8 kB; "" without one.
std::string lastLineWith(const std::filesystem::path& log, const std::string& word);

}  // namespace pfem
