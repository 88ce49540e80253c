#pragma once
// Quoted keywords such as "(p|U).*": POSIX extended regular expressions which must match the whole key.

#include <memory>
#include <string>

#include "base/error.hpp"

namespace pfem {

class KeyPattern {
public:
    /// "(?i)" at the start: upper and lower case are the same. Throws UserError for a malformed expression.
    KeyPattern(const std::string& expression, const Location& where);
    bool matches(const std::string& key) const;

    /// False for quoted words without any special character: they are ordinary keys.
    static bool isPattern(const std::string& text);

private:
    struct Compiled;
    std::shared_ptr<const Compiled> compiled_;
};

}  // namespace pfem
