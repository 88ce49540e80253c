#include "dictionary/keyPattern.hpp"

#include <regex.h>

#include <algorithm>
#include <charconv>

namespace pfem {

struct KeyPattern::Compiled {
    regex_t regex{};
    Compiled() = default;
    Compiled(const Compiled&) = delete;
    Compiled& operator=(const Compiled&) = delete;
    ~Compiled() { regfree(&regex); }
};

namespace {

/// Nested repeats such as ((a{255}){255}){255}, or a++++++++++++++++++++ (x+ is compiled as xx*), make regcomp take all
/// memory.
bool tooCostly(const std::string& expression) {
    auto cost = static_cast<double>(expression.size());
    for (std::size_t i = 0; i < expression.size(); ++i) {
        if (expression[i] == '+' && i > 0 && std::string("+*?})").find(expression[i - 1]) != std::string::npos)
            cost *= 2;
        if (expression[i] != '{') continue;
        const auto close = std::min(expression.find('}', i), expression.size());
        double largest = 1;
        for (std::size_t k = i + 1; k < close; ++k) {
            int n = 0;
            const auto end = std::from_chars(expression.data() + k, expression.data() + close, n).ptr;
            if (end != expression.data() + k) k = static_cast<std::size_t>(end - expression.data());
            largest = std::max(largest, static_cast<double>(n));
        }
        cost *= largest;
    }
    return cost > 1e5 || expression.size() > 4000;
}

}  // namespace

KeyPattern::KeyPattern(const std::string& expression, const Location& where) {
    const bool ignoreCase = expression.starts_with("(?i)");
    const std::string body = ignoreCase ? expression.substr(4) : expression;
    if (tooCostly(body)) throw UserError("Regular expression \"" + expression.substr(0, 80) + "\" is too large", where);
    for (std::size_t i = 0; i + 1 < body.size(); ++i) {  // \1 may take exponential time
        if (body[i] == '\\' && body[i + 1] >= '1' && body[i + 1] <= '9') {
            throw UserError("Keyword \"" + expression + "\": back references are not supported", where);
        }
        if (body[i] == '\\') ++i;
    }
    auto compiled = std::make_shared<Compiled>();
    const std::string whole = "^(" + body + ")$";
    const int status =
        regcomp(&compiled->regex, whole.c_str(), REG_EXTENDED | REG_NOSUB | (ignoreCase ? REG_ICASE : 0));
    if (status != 0) {
        char reason[128];
        regerror(status, &compiled->regex, reason, sizeof reason);
        throw UserError("Keyword \"" + expression + "\" is not a regular expression: " + reason, where);
    }
    compiled_ = compiled;
}

bool KeyPattern::matches(const std::string& key) const {
    return regexec(&compiled_->regex, key.c_str(), 0, nullptr, 0) == 0;
}

bool KeyPattern::isPattern(const std::string& text) {
    return text.find_first_of(".*+?()[]{}|^$\\") != std::string::npos;
}

}  // namespace pfem
