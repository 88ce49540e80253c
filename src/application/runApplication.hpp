#pragma once
// The frame around every main: options, help, start banner, errors to exit codes.

#include <functional>
#include <string>

#include "application/options.hpp"

namespace pfem {

/// Parse the command line, print help if asked for, and call `body`; its value is the exit code.
/// A UserError, StepFailure or any other exception is printed as OpenFOAM prints a fatal error (on stderr):
/// exit code 1, no stack trace.
int runApplication(int argc, const char* const* argv, const std::string& description, const OptionsSpec& spec,
                   const std::function<int(const Options&)>& body);

/// The first lines of a log: Build, Exec, Date, Time, Host, PID, Case, nProcs.
std::string startBanner(const Options& options, const Case& theCase, int nProcs = 1);

/// The text of a fatal error:
/// "--> FOAM FATAL IO ERROR:", the message, "file: ... at line N.", "FOAM exiting".
std::string fatalText(const std::exception& error);

}  // namespace pfem
