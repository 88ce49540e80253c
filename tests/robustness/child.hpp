#pragma once
// What a program would do, in a process of its own: its exit code and all that it says.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <iostream>
#include <sstream>
#include <string>

#include "application/runApplication.hpp"
#include "base/error.hpp"

namespace pfem::test {

#if defined(__SANITIZE_ADDRESS__)
constexpr unsigned patience = 100;  // [s], the sanitizers take ten times as long
#else
constexpr unsigned patience = 10;
#endif

struct Outcome {
    int code = 0;      // as the program would end; -signal when it is killed (SIGALRM: out of patience)
    std::string text;  // standard output and error
};

inline Outcome inChild(const std::function<void()>& body) {
    int pipes[2];
    if (pipe(pipes) != 0) throw InternalError("pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(pipes[0]);
        std::ostringstream said;
        std::cout.rdbuf(said.rdbuf());
        std::cerr.rdbuf(said.rdbuf());
        alarm(patience);
        int code = 0;
        try {
            body();
        } catch (const std::exception& error) {
            code = 1;
            said << fatalText(error);
        }
        const std::string text = said.str();
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t n = write(pipes[1], text.data() + done, text.size() - done);
            if (n <= 0) break;
            done += static_cast<std::size_t>(n);
        }
        _exit(code);
    }
    close(pipes[1]);
    Outcome result;
    char buffer[4096];
    for (ssize_t n; (n = read(pipes[0], buffer, sizeof buffer)) > 0;)
        result.text.append(buffer, static_cast<std::size_t>(n));
    close(pipes[0]);
    int status = 0;
    waitpid(child, &status, 0);
    result.code = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
    return result;
}

}  // namespace pfem::test
