#include "dictionary/dimensions.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

namespace pfem {

namespace {

const char* const baseUnits[7] = {"kg", "m", "s", "K", "mol", "A", "cd"};

const std::map<std::string, Dimensions>& units() {
    static const std::map<std::string, Dimensions> table = {
        {"kg", {1, 0, 0, 0, 0, 0, 0}},  {"m", {0, 1, 0, 0, 0, 0, 0}},   {"s", {0, 0, 1, 0, 0, 0, 0}},
        {"K", {0, 0, 0, 1, 0, 0, 0}},   {"mol", {0, 0, 0, 0, 1, 0, 0}}, {"A", {0, 0, 0, 0, 0, 1, 0}},
        {"cd", {0, 0, 0, 0, 0, 0, 1}},  {"N", {1, 1, -2, 0, 0, 0, 0}},  {"Pa", {1, -1, -2, 0, 0, 0, 0}},
        {"J", {1, 2, -2, 0, 0, 0, 0}},  {"W", {1, 2, -3, 0, 0, 0, 0}},  {"Hz", {0, 0, -1, 0, 0, 0, 0}},
        {"rad", {0, 0, 0, 0, 0, 0, 0}},
    };
    return table;
}

void addScaled(Dimensions& sum, const Dimensions& d, double factor) {
    for (std::size_t i = 0; i < 7; ++i) sum[i] += factor * d[i];
}

/// product := power ((" " | "*" | "." | "/") power)* ; power := (unit | "1" | "(" product ")") ["^" number]
class SymbolicDimensions {
public:
    SymbolicDimensions(const std::string& text, const TokenReader& tokens) : text_(text), tokens_(tokens) {}

    Dimensions parse() {
        const Dimensions result = product(0);
        if (position_ < text_.size()) fail();
        return result;
    }

private:
    char peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }
    void skipSpace() {
        while (peek() == ' ') ++position_;
    }
    [[noreturn]] void fail() const { tokens_.fatal("cannot understand the dimensions [" + text_ + "]"); }

    Dimensions product(int depth) {
        if (depth > 20) fail();
        Dimensions result{};
        double sign = 1;
        while (true) {
            skipSpace();
            if (peek() == '\0' || peek() == ')') return result;
            addScaled(result, power(depth), sign);
            skipSpace();
            sign = peek() == '/' ? -1 : 1;
            if (peek() == '/' || peek() == '*' || peek() == '.') {
                ++position_;
                skipSpace();
                if (peek() == '\0' || peek() == ')') fail();
            }
        }
    }

    Dimensions power(int depth) {
        Dimensions base{};
        if (peek() == '(') {
            ++position_;
            base = product(depth + 1);
            if (peek() != ')') fail();
            ++position_;
        } else if (peek() == '1') {
            ++position_;
        } else {
            std::string unit;
            while (std::isalpha(static_cast<unsigned char>(peek()))) unit += text_[position_++];
            const auto known = units().find(unit);
            if (known == units().end()) {
                if (unit.empty()) fail();
                tokens_.fatal("unknown unit '" + unit + "' in the dimensions [" + text_ +
                              "]; use kg m s K mol A cd N Pa J W Hz");
            }
            base = known->second;
        }
        if (peek() != '^') return base;
        ++position_;
        double exponent = 0;
        const char* first = text_.data() + position_;
        const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), exponent);
        if (error != std::errc() || !(std::abs(exponent) < 100)) fail();
        position_ += static_cast<std::size_t>(end - first);
        Dimensions result{};
        addScaled(result, base, exponent);
        return result;
    }

    const std::string& text_;
    const TokenReader& tokens_;
    std::size_t position_ = 0;
};

}  // namespace

Dimensions readDimensions(TokenReader& tokens) {
    tokens.expect('[');
    std::vector<double> numbers;
    std::string text;
    bool symbolic = false;
    while (!tokens.peek().is(']')) {
        const Token token = tokens.next();
        if (token.isEnd()) tokens.fatal("dimensions '[' without ']'");
        numbers.push_back(token.number);
        symbolic = symbolic || !token.isNumber();
        if (token.spaceBefore && !text.empty()) text += ' ';
        text += token.text;
    }
    tokens.expect(']');
    if (symbolic) return SymbolicDimensions(text, tokens).parse();
    if (numbers.size() != 0 && numbers.size() != 5 && numbers.size() != 7) {
        tokens.fatal("dimensions need 5 or 7 numbers [kg m s K mol A cd], not " + std::to_string(numbers.size()));
    }
    Dimensions result{};
    std::copy(numbers.begin(), numbers.end(), result.begin());
    return result;
}

bool sameDimensions(const Dimensions& a, const Dimensions& b) {
    for (std::size_t i = 0; i < 7; ++i) {
        if (std::abs(a[i] - b[i]) > 1e-9) return false;
    }
    return true;
}

std::string toString(const Dimensions& dimensions) {
    std::string numbers, symbols;
    for (std::size_t i = 0; i < 7; ++i) {
        numbers += fmt::format("{}{}", i > 0 ? " " : "", dimensions[i]);
        if (dimensions[i] == 0) continue;
        if (!symbols.empty()) symbols += ' ';
        symbols += dimensions[i] == 1 ? baseUnits[i] : fmt::format("{}^{}", baseUnits[i], dimensions[i]);
    }
    return "[" + numbers + "]" + (symbols.empty() ? "" : " (" + symbols + ")");
}

}  // namespace pfem
