// The only file that knows muParser.
#include "dictionary/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <numbers>

namespace pfem {

namespace {

constexpr std::size_t maxLength = 10'000;

double degToRad(double x) { return x * std::numbers::pi / 180; }
double radToDeg(double x) { return x * 180 / std::numbers::pi; }
double asBool(double x) { return x != 0; }
double sqr(double x) { return x * x; }
double magSqr(double x) { return x * x; }
double mag(double x) { return std::abs(x); }
double power(double x, double y) { return std::pow(x, y); }
double remainderOf(double x, double y) { return std::fmod(x, y); }
double hypotenuse(double x, double y) { return std::hypot(x, y); }
double pos(double x) { return x > 0; }
double pos0(double x) { return x >= 0; }
double neg(double x) { return x < 0; }
double neg0(double x) { return x <= 0; }
double floorOf(double x) { return std::floor(x); }
double ceilOf(double x) { return std::ceil(x); }
double roundOf(double x) { return std::round(x); }
double cubeRoot(double x) { return std::cbrt(x); }
double negation(double x) { return x == 0; }

/// OpenFOAM writes pi(); muParser has constants.
std::string withConstants(std::string text) {
    const auto isName = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (auto at = text.find("pi()"); at != std::string::npos; at = text.find("pi()", at + 1)) {
        if (at == 0 || !isName(text[at - 1])) text.erase(at + 2, 2);
    }
    return text;
}

void defineFunctions(mu::Parser& parser) {
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("true", 1);
    parser.DefineConst("false", 0);
    parser.DefineFun("degToRad", degToRad);
    parser.DefineFun("radToDeg", radToDeg);
    parser.DefineFun("bool", asBool);
    parser.DefineFun("sqr", sqr);
    parser.DefineFun("magSqr", magSqr);
    parser.DefineFun("mag", mag);
    parser.DefineFun("pow", power);
    parser.DefineFun("fmod", remainderOf);
    parser.DefineFun("hypot", hypotenuse);
    parser.DefineFun("pos", pos);
    parser.DefineFun("pos0", pos0);
    parser.DefineFun("neg", neg);
    parser.DefineFun("neg0", neg0);
    parser.DefineFun("floor", floorOf);
    parser.DefineFun("ceil", ceilOf);
    parser.DefineFun("round", roundOf);
    parser.DefineFun("cbrt", cubeRoot);
    parser.DefineInfixOprt("!", negation);
}

}  // namespace

struct Expression::Impl {
    std::string text;
    std::vector<std::string> names;
    Location where;
    std::vector<double> values;
    mu::Parser parser;

    [[noreturn]] void fail(const std::string& reason) const {
        throw UserError("Cannot evaluate \"" + text + "\": " + reason, where);
    }

    Impl(std::string t, std::vector<std::string> n, Location w)
        : text(std::move(t)), names(std::move(n)), where(std::move(w)), values(names.size(), 1.0) {
        if (text.size() > maxLength) throw UserError("Expression is too long", where);
        try {
            defineFunctions(parser);
            for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &values[i]);
            parser.SetExpr(withConstants(text));
            int results = 0;
            parser.Eval(results);
            if (results != 1) fail("it is a list, not one value");
        } catch (const mu::Parser::exception_type& error) {
            fail(error.GetMsg());
        }
    }

    double evaluate() {
        double result = 0;
        try {
            result = parser.Eval();
        } catch (const mu::Parser::exception_type& error) {
            fail(error.GetMsg());
        }
        if (!std::isfinite(result)) fail("the value is not a finite number");
        return result;
    }
};

Expression::Expression(const std::string& text, std::vector<std::string> variables, Location where)
    : impl_(std::make_unique<Impl>(text, std::move(variables), std::move(where))) {}

Expression::Expression(const Expression& other)
    : impl_(std::make_unique<Impl>(other.impl_->text, other.impl_->names, other.impl_->where)) {}

Expression::~Expression() = default;

double Expression::operator()(const std::vector<double>& values) const {
    if (values.size() != impl_->values.size()) throw InternalError("Expression: wrong number of variables");
    std::copy(values.begin(), values.end(), impl_->values.begin());
    return impl_->evaluate();
}

double evaluateScalar(const std::string& text, const Location& where) { return Expression(text, {}, where)({}); }

std::string evaluateToText(const std::string& text, const Location& where) {
    const auto number = [](double x) {
        x += 0.0;  // no -0
        return x == std::rint(x) && std::abs(x) < 1e15 ? fmt::format("{:.0f}", x) : fmt::format("{}", x);
    };
    if (!containsVector(text)) return number(evaluateScalar(text, where));
    const EvaluatedVector v = evaluateVector(text, where);
    if (!v.isVector) return number(v.value[0]);
    return fmt::format("({} {} {})", number(v.value[0]), number(v.value[1]), number(v.value[2]));
}

}  // namespace pfem
