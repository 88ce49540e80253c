// Formulas with vectors: a small grammar of its own; every scalar function call goes to evaluateScalar().
//
//     sum     := product (("+" | "-") product)*
//     product := factor (("*" | "/" | "&" | "^") factor)*
//     factor  := "-" factor | "(" sum ")" | "(" sum sum sum ")" | name "(" sum ("," sum)* ")" | number

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cctype>
#include <charconv>

#include "dictionary/expression.hpp"

namespace pfem {

namespace {

class VectorFormula {
public:
    VectorFormula(const std::string& text, const Location& where) : text_(text), where_(where) {}

    EvaluatedVector evaluate() {
        EvaluatedVector result = sum();
        if (peek() != '\0') fail("cannot understand it from '" + text_.substr(position_) + "' on");
        if (!result.value.allFinite()) fail("the value is not finite");
        return result;
    }

private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw UserError("Cannot evaluate \"" + text_ + "\": " + reason, where_);
    }

    char peek() {
        while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_]))) ++position_;
        return position_ < text_.size() ? text_[position_] : '\0';
    }

    static EvaluatedVector scalar(double x) { return {Eigen::Vector3d(x, 0, 0), false}; }

    /// A sign with a space before but none behind it starts a new component within "(1 -2 3)".
    bool startsComponent() const {
        return inTuple_ && position_ > 0 && std::isspace(static_cast<unsigned char>(text_[position_ - 1])) &&
               position_ + 1 < text_.size() && !std::isspace(static_cast<unsigned char>(text_[position_ + 1]));
    }

    EvaluatedVector sum() {
        EvaluatedVector left = product();
        for (char c = peek(); (c == '+' || c == '-') && !startsComponent(); c = peek()) {
            ++position_;
            const EvaluatedVector right = product();
            if (left.isVector != right.isVector) fail("sum of a scalar and a vector");
            left.value += c == '+' ? right.value : Eigen::Vector3d(-right.value);
        }
        return left;
    }

    EvaluatedVector product() {
        EvaluatedVector left = factor();
        for (char c = peek(); c == '*' || c == '/' || c == '&' || c == '^'; c = peek()) {
            ++position_;
            left = combined(left, c, factor());
        }
        return left;
    }

    EvaluatedVector combined(const EvaluatedVector& a, char operation, const EvaluatedVector& b) {
        const double x = a.value[0];
        const double y = b.value[0];
        if (a.isVector && b.isVector) {
            if (operation == '&') return scalar(a.value.dot(b.value));
            if (operation == '^') return {a.value.cross(b.value), true};
            fail("vectors have products & (dot) and ^ (cross) only");
        }
        if (operation == '*')
            return a.isVector ? EvaluatedVector{a.value * y, true} : EvaluatedVector{b.value * x, b.isVector};
        if (b.isVector || (a.isVector && operation != '/')) fail(std::string("scalar ") + operation + " vector");
        if (operation == '/') return {a.value / y, a.isVector};
        if (operation == '^') return scalar(std::pow(x, y));
        fail("'&' needs two vectors");
    }

    EvaluatedVector factor() {
        if (++depth_ > 100) fail("it is nested too deeply");
        EvaluatedVector result;
        const char c = peek();
        if (c == '-' || c == '+') {
            ++position_;
            result = factor();
            if (c == '-') result.value = -result.value;
        } else if (c == '(') {
            ++position_;
            result = tuple(' ');
        } else if (std::isalpha(static_cast<unsigned char>(c)) || c == '_') {
            result = call();
        } else {
            double number = 0;
            const char* first = text_.data() + position_;
            const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), number);
            if (error != std::errc()) fail("a number is expected at '" + text_.substr(position_) + "'");
            position_ += static_cast<std::size_t>(end - first);
            result = scalar(number);
        }
        --depth_;
        return result;
    }

    std::vector<EvaluatedVector> arguments(char separator) {
        std::vector<EvaluatedVector> values;
        const bool outer = inTuple_;
        inTuple_ = separator == ' ';
        while (peek() != ')') {
            if (peek() == '\0') fail("')' is missing");
            if (!values.empty() && separator == ',') {
                if (peek() != ',') fail("',' is missing");
                ++position_;
            }
            values.push_back(sum());
        }
        ++position_;
        inTuple_ = outer;
        return values;
    }

    EvaluatedVector tuple(char separator) {
        const auto values = arguments(separator);
        if (separator == ' ' && values.size() == 1) return values[0];
        if (values.size() != 3) fail("a vector needs 3 components");
        EvaluatedVector result;
        result.isVector = true;
        for (int i = 0; i < 3; ++i) {
            const auto& component = values[static_cast<std::size_t>(i)];
            if (component.isVector) fail("a component is a vector");
            result.value[i] = component.value[0];
        }
        return result;
    }

    EvaluatedVector call() {
        std::string name;
        while (std::isalnum(static_cast<unsigned char>(text_[position_])) || text_[position_] == '_') {
            name += text_[position_++];
            if (position_ >= text_.size()) break;
        }
        if (peek() != '(') return scalar(evaluateScalar(name, where_));
        ++position_;
        if (name == "vector") return tuple(',');
        const auto values = arguments(',');
        if (values.size() == 1 && values[0].isVector) {
            if (name == "mag") return scalar(values[0].value.norm());
            if (name == "magSqr") return scalar(values[0].value.squaredNorm());
            if (name == "normalise") return {values[0].value.normalized(), true};
        }
        std::string text = name + "(";
        for (const auto& v : values) {
            if (v.isVector) fail(name + "() of a vector");
            text += fmt::format("{}{}", text.back() == '(' ? "" : ",", v.value[0]);
        }
        return scalar(evaluateScalar(text + ")", where_));
    }

    const std::string& text_;
    const Location& where_;
    std::size_t position_ = 0;
    int depth_ = 0;
    bool inTuple_ = false;
};

}  // namespace

bool containsVector(const std::string& text) {
    if (text.find("vector(") != std::string::npos) return true;
    // "(1 0 0)": two numbers with only blanks between them
    const auto isEnd = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == ')'; };
    const auto isStart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '.'; };
    for (auto blank = text.find_first_of(" \t\n"); blank != std::string::npos;) {
        const auto next = text.find_first_not_of(" \t\n", blank);
        if (next == std::string::npos) return false;
        if (blank > 0 && isEnd(text[blank - 1]) && isStart(text[next])) return true;
        blank = text.find_first_of(" \t\n", next);
    }
    return false;
}

EvaluatedVector evaluateVector(const std::string& text, const Location& where) {
    return VectorFormula(text, where).evaluate();
}

}  // namespace pfem
