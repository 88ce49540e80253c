#include "application/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cctype>
#include <filesystem>

#include "base/error.hpp"

namespace pfem {

namespace po = boost::program_options;

namespace {

const std::vector<OptionSpec>& commonOptions() {
    static const std::vector<OptionSpec> common{
        {"case", "dir", "Specify case directory to use (instead of cwd)"},
        {"help", "", "Display help and exit"},
        {"help-keywords", "", "Display the entries of all dictionaries and exit"},
        {"help-man", "", "Display the man page's source and exit"},
    };
    return common;
}

/// "--name" or "-name=value" as the user meant it: "name".
std::string bareName(std::string token) {
    token.erase(0, token.find_first_not_of('-'));
    return token.substr(0, token.find('='));
}

bool looksLikeOption(const std::string& token) {
    return token.size() > 1 && token[0] == '-' && !std::isdigit(static_cast<unsigned char>(token[1])) &&
           token[1] != '.';
}

[[noreturn]] void invalidOption(const std::string& token, const std::vector<OptionSpec>& all) {
    std::vector<std::string> names;
    for (const auto& option : all) names.push_back(option.name);
    const std::string near = nearestWord(bareName(token), names);
    throw UserError("Invalid option: -" + bareName(token) + (near.empty() ? "" : " (did you mean '-" + near + "'?)"));
}

}  // namespace

std::vector<OptionSpec> allOptions(const OptionsSpec& spec) {
    std::vector<OptionSpec> all = commonOptions();
    all.insert(all.end(), spec.options.begin(), spec.options.end());
    std::sort(all.begin(), all.end(), [](const OptionSpec& a, const OptionSpec& b) { return a.name < b.name; });
    return all;
}

OptionsSpec& OptionsSpec::add(const std::string& name, const std::string& argument, const std::string& help) {
    options.push_back({name, argument, help});
    return *this;
}

OptionsSpec& OptionsSpec::addTimeSelection() {
    add("time", "ranges", "Comma-separated time ranges - eg, ':10,20,40:70,1000:'");
    add("latestTime", "", "Select the latest time");
    return add("noZero", "", "Exclude the '0' time");
}

Options::Options(int argc, const char* const* argv, const OptionsSpec& spec) {
    commandLine_.assign(argv, argv + argc);
    program_ = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "pfem";
    const auto all = allOptions(spec);

    po::options_description description;
    for (const auto& option : all) {
        if (option.argument.empty())
            description.add_options()(option.name.c_str(), "");
        else
            description.add_options()(option.name.c_str(), po::value<std::vector<std::string>>(), "");
    }
    const int style = (po::command_line_style::unix_style | po::command_line_style::allow_long_disguise) &
                      ~po::command_line_style::allow_guessing & ~po::command_line_style::allow_short;
    try {
        const auto parsed =
            po::command_line_parser(argc, argv).options(description).style(style).allow_unregistered().run();
        for (const auto& option : parsed.options) {
            if (option.unregistered) invalidOption(option.original_tokens.at(0), all);
            if (option.position_key >= 0) {  // an unknown -foo arrives here as well
                for (const auto& token : option.value) {
                    if (looksLikeOption(token)) invalidOption(token, all);
                    arguments_.push_back(token);
                }
                continue;
            }
            values_[option.string_key] = option.value.empty() ? "" : option.value.back();
        }
    } catch (const po::unknown_option& error) {
        invalidOption(error.get_option_name(), all);
    } catch (const po::invalid_command_line_syntax& error) {
        const std::string name = bareName(error.get_option_name());
        const bool isSwitch = error.kind() == po::invalid_syntax::extra_parameter;
        throw UserError("Option -" + name + (isSwitch ? " takes no argument" : " requires an argument"));
    } catch (const po::error& error) {
        throw UserError(std::string("Invalid command line: ") + error.what());
    }
    if (!wantsHelp() && arguments_.size() != spec.arguments.size())
        throw UserError(fmt::format("Expected {} arguments but found {}", spec.arguments.size(), arguments_.size()) +
                        (arguments_.empty() ? "" : ": '" + arguments_.front() + "'"));
}

std::string Options::get(const std::string& name, const std::string& defaultValue) const {
    const auto value = values_.find(name);
    return value == values_.end() ? defaultValue : value->second;
}

Case Options::openCase() const { return Case(get("case", "."), program_); }

std::string helpText(const std::string& program, const std::string& description, const OptionsSpec& spec) {
    std::string text = "\nUsage: " + program + " [OPTIONS]";
    for (const auto& argument : spec.arguments) text += " <" + argument + ">";
    text += "\nOptions:\n";
    for (const auto& option : allOptions(spec)) {
        const std::string left = "  -" + option.name + (option.argument.empty() ? "" : " <" + option.argument + ">");
        text += left.size() < 19 ? fmt::format("{:<20}{}\n", left, option.help)
                                 : fmt::format("{}\n{:<20}{}\n", left, "", option.help);
    }
    return text + "\n" + description + "\n\nUsing: libpfem-" + PFEM_VERSION + "\n\n";
}

}  // namespace pfem
