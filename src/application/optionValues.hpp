#pragma once
// Values of options that are more than a word: numbers and lists, in a dictionary's notation.

#include <fmt/format.h>

#include <string>

#include "application/options.hpp"
#include "base/error.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// The value of an option that was given. `form` says what is expected, for the message: "a whole number",
/// "'(x y)'". Throws UserError `-box needs '((x y) (x y))', not '...'`.
template <class Value>
Value optionValue(const Options& options, const std::string& name, const std::string& form) {
    try {
        return Dictionary::parse(name + " " + options.get(name) + ";", "-" + name).get<Value>(name);
    } catch (const UserError&) {
        throw UserError(fmt::format("-{} needs {}, not '{}'", name, form, options.get(name)));
    }
}

/// A whole number from `low` to `high`; `defaultValue` without the option. Throws UserError.
inline int wholeNumber(const Options& options, const std::string& name, int defaultValue, int low, int high) {
    const int value = options.found(name) ? optionValue<int>(options, name, "a whole number") : defaultValue;
    if (value < low || value > high)
        throw UserError(fmt::format("-{} must be from {} to {}, not {}", name, low, high, value));
    return value;
}

}  // namespace pfem
