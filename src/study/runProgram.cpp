#include "study/runProgram.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "base/error.hpp"
#include "case/interrupt.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// In the child: a group of its own, output to the log, then the program; 127 when there is none, as a shell answers.
[[noreturn]] void become(std::vector<char*>& arguments, const fs::path& place, int log, pid_t parent) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(128 + SIGTERM);  // it has died in between
    const int nothing = open("/dev/null", O_RDONLY);
    if (chdir(place.c_str()) == 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(log, STDOUT_FILENO) >= 0 &&
        dup2(log, STDERR_FILENO) >= 0)
        execvp(arguments[0], arguments.data());
    _exit(127);
}

/// Wait for the last process of the group; returns the status of its leader.
int waitForGroup(pid_t leader, const std::string& name, const std::function<void()>& tick) {
    int status = 0;
    bool handedOn = false, leaderEnded = false;
    for (int n = 1;; ++n) {
        int code = 0;
        const pid_t ended = waitpid(-leader, &code, WNOHANG);
        if (ended == leader) {
            status = code;
            leaderEnded = true;
        }
        if (ended > 0) continue;
        if (ended < 0 && errno == ECHILD && leaderEnded) return status;
        if (ended < 0 && errno != EINTR) throw UserError("lost sight of " + name + ": " + std::strerror(errno));
        if (interrupted() && !handedOn) {
            kill(-leader, SIGTERM);
            handedOn = true;
        }
        if (n % 20 == 0 && tick) tick();
        usleep(50000);
    }
}

}  // namespace

std::string siblingProgram(const std::string& name) {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    const fs::path sibling = self.parent_path() / name;
    return !error && fs::exists(sibling) ? sibling.string() : name;
}

int runProgram(const std::vector<std::string>& command, const fs::path& place, const fs::path& log,
               const std::function<void()>& tick) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0) throw UserError("cannot write \"" + log.string() + "\": " + std::strerror(errno), {log.string(), 0});
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // what a shell leaves behind when it is stopped comes to us
    const pid_t parent = getpid(), child = fork();
    if (child == 0) become(arguments, place, file, parent);
    const int failure = errno;
    close(file);
    if (child < 0) throw UserError("cannot start " + command[0] + ": " + std::strerror(failure));
    setpgid(child, child);  // whoever comes first
    const int status = waitForGroup(child, command[0], tick);
    if (WIFSIGNALED(status)) return 128 + WTERMSIG(status);
    if (WEXITSTATUS(status) == 127) throw UserError("cannot find the program " + command[0]);
    return WEXITSTATUS(status);
}

std::string lastLineWith(const fs::path& log, const std::string& word) {
    std::ifstream stream(log, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::streamoff>(stream.tellg());
    stream.seekg(std::max<std::streamoff>(0, size - 8192));
    std::string last;
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with(word)) last = line;
    return last;
}

}  // namespace pfem
