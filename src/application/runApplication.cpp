#include "application/runApplication.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <signal.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <ctime>
#include <iostream>
#include <new>

#include "base/error.hpp"
#include "reference/keywords.hpp"

namespace pfem {

namespace {

std::string now(const char* format) {
    const std::time_t seconds = std::time(nullptr);
    std::tm local{};
    localtime_r(&seconds, &local);
    char text[64];
    return {text, std::strftime(text, sizeof text, format, &local)};
}

/// Freed memory stays with the program, which asks for the same again in its next step; of all threads in one place,
/// or each would keep what the others could use.
void keepMemory() {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, 1 << 24);
#endif
}

std::string host() {
    utsname names{};
    return uname(&names) == 0 ? names.nodename : "unknown";
}

}  // namespace

std::string fatalText(const std::exception& error) {
    std::string where;
    bool io = false;
    std::string message = error.what();
    if (const auto* user = dynamic_cast<const UserError*>(&error)) {
        io = !user->where().file.empty();
        if (io) where = "file: " + user->where().file;
        if (io && user->where().lastLine > 0)
            where += fmt::format(" from line {} to line {}", user->where().line, user->where().lastLine);
        else if (io && user->where().line > 0)
            where += fmt::format(" at line {}", user->where().line);
        if (io) where += ".\n\n";
    } else if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        message = "not enough memory";
    } else if (dynamic_cast<const StepFailure*>(&error) == nullptr) {
        message += "\n\nThis is an error of the program, not of the case: please report it with the case.";
    }
    return std::string("\n\n--> FOAM FATAL ") + (io ? "IO ERROR:\n" : "ERROR:\n") + message + "\n\n" + where +
           "FOAM exiting\n\n";
}

std::string startBanner(const Options& options, const Case& theCase, int nProcs) {
    std::string exec = options.program();
    for (std::size_t i = 1; i < options.commandLine().size(); ++i) exec += " " + options.commandLine()[i];
    std::string line = "// ";
    for (int i = 0; i < 37; ++i) line += "* ";
    return "/*---------------------------------------------------------------------------*\\\n"
           "| libpfem: Particle Finite Element Method with nodal integration              |\n"
           "\\*---------------------------------------------------------------------------*/\n" +
           fmt::format(
               "Build  : PFEM={}\nExec   : {}\nDate   : {}\nTime   : {}\nHost   : {}\nPID    : {}\n"
               "Case   : {}\nnProcs : {}\n",
               PFEM_VERSION, exec, now("%b %d %Y"), now("%H:%M:%S"), host(), getpid(), theCase.root().string(),
               nProcs) +
           line + "//\n";
}

int runApplication(int argc, const char* const* argv, const std::string& description, const OptionsSpec& spec,
                   const std::function<int(const Options&)>& body) {
    keepMemory();
    signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error with a message, not the end
    const std::string program = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "pfem";
    try {
        const Options options = [&] {
            try {
                return Options(argc, argv, spec);
            } catch (const UserError& error) {
                std::cerr << helpText(program, description, spec) << error.what() << "\nSee '" << program
                          << " -help' for usage\n";
                std::exit(1);
            }
        }();
        if (options.wantsHelp()) {
            std::cout << (options.found("help")            ? helpText(program, description, spec)
                          : options.found("help-keywords") ? keywordPage()
                                                           : manPage(program, description, spec));
            return 0;
        }
        const int code = body(options);
        std::cout.flush();
        if (!std::cout) throw UserError("cannot write the log: standard output is full or closed");
        return code;
    } catch (const std::exception& error) {
        std::cout.flush();
        std::cerr << fatalText(error);
        return 1;
    }
}

}  // namespace pfem
