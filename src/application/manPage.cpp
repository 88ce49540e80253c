// The man page of a program, from the same declarations as its -help.

#include <fmt/format.h>

#include "application/options.hpp"

namespace pfem {

namespace {

/// A hyphen is a minus sign, a leading dot or quote no request.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '-' || c == '\\') result += '\\';
        result += c == '\\' ? 'e' : c;
    }
    if (result.starts_with('.') || result.starts_with('\'')) result = "\\&" + result;
    return result;
}

}  // namespace

std::string manPage(const std::string& program, const std::string& description, const OptionsSpec& spec) {
    std::string text = fmt::format(".TH {} 1 \"\" \"libpfem {}\" \"libpfem\"\n", program, PFEM_VERSION);
    text += fmt::format(".SH NAME\n{} \\- {}\n", program, roff(description));
    text += fmt::format(".SH SYNOPSIS\n.B {}\n[OPTIONS]", program);
    for (const auto& argument : spec.arguments) text += fmt::format(" <{}>", roff(argument));
    text += "\n.SH OPTIONS\n";
    for (const auto& option : allOptions(spec))
        text += fmt::format(".TP\n.B {}{}\n{}\n", roff("-" + option.name),
                            option.argument.empty() ? "" : roff(" <" + option.argument + ">"), roff(option.help));
    return text +
           ".SH EXIT STATUS\n0 on success, 1 after an error, whose message is on the standard error stream.\n"
           ".SH SEE ALSO\nThe project's README.md; the entries of all dictionaries: doc/keywords.md, or the "
           "option "
           "\\-help\\-keywords.\n";
}

}  // namespace pfem
