#pragma once
// The command line in OpenFOAM's manner: single-dash long options, -case and -help everywhere.

#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace pfem {

/// One option. `argument`: what the help calls its value ("dir"), empty for a switch.
struct OptionSpec {
    std::string name;
    std::string argument;
    std::string help;
};

/// What a program accepts beside -case and -help.
struct OptionsSpec {
    std::vector<OptionSpec> options;
    std::vector<std::string> arguments;  // names of the required positional arguments

    OptionsSpec& add(const std::string& name, const std::string& argument, const std::string& help);
    /// -time ranges, -latestTime, -noZero
    OptionsSpec& addTimeSelection();
};

/// Those of a program and those that all have, by name.
std::vector<OptionSpec> allOptions(const OptionsSpec& spec);

/// The parsed command line.
class Options {
public:
    /// Throws UserError "Invalid option: -foo" and the like.
    Options(int argc, const char* const* argv, const OptionsSpec& spec);

    bool found(const std::string& name) const { return values_.count(name) > 0; }
    std::string get(const std::string& name, const std::string& defaultValue = "") const;
    const std::vector<std::string>& arguments() const { return arguments_; }

    /// Is only a text asked for: -help, -help-keywords, -help-man?
    bool wantsHelp() const { return found("help") || found("help-keywords") || found("help-man"); }

    /// The program's name without its folder.
    const std::string& program() const { return program_; }
    const std::vector<std::string>& commandLine() const { return commandLine_; }

    /// The folder given by -case, or the current one. Throws UserError when it cannot be opened.
    Case openCase() const;

private:
    std::string program_;
    std::vector<std::string> commandLine_;
    std::map<std::string, std::string> values_;
    std::vector<std::string> arguments_;
};

/// The text of -help-man, for the man program.
std::string manPage(const std::string& program, const std::string& description, const OptionsSpec& spec);

/// The text of -help: "Usage: program [OPTIONS]", the options in two columns, the description.
std::string helpText(const std::string& program, const std::string& description, const OptionsSpec& spec);

}  // namespace pfem
