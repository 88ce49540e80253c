#include "dictionary/function1.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "dictionary/function1Types.hpp"

namespace pfem {

namespace {

using namespace function1Detail;

/// What follows the type's word in `key type value;`.
template <class T>
Function1Ptr<T> readInline(const Dictionary& dict, const std::string& key) {
    TokenReader tokens = dict.reader(key);
    const Token first = tokens.peek();
    std::string type = "constant";
    if (first.isWord()) type = tokens.read<std::string>();
    Function1Ptr<T> function;
    if (type == "constant")
        function = std::make_shared<Constant<T>>(tokens.read<T>());
    else if (type == "table")
        function = std::make_shared<Table1<T>>(readPairs<T>(tokens), OutOfBounds::clamp, dict.where(key));
    else if (type == "polynomial")
        function = std::make_shared<Polynomial<T>>(readTerms<T>(tokens));
    else if (type == "expression")
        function = std::make_shared<Formula<T>>(readFormulas<T>(tokens), dict.where(key));
    else if (const auto types = function1Types(); std::find(types.begin(), types.end(), type) != types.end())
        dict.fatal(key, "'" + type + "' has entries of its own: " + key + " { type " + type + "; ... }");
    else
        dict.fatal(key, notValid(type, "function of time", function1Types()));
    tokens.end();
    return function;
}

template <class T>
Function1Ptr<T> readBlock(const Dictionary& dict) {
    const std::string type = dict.choice("type", function1Types());
    if (type == "constant") return readFunction1<T>(dict, "value");
    if (type == "polynomial") {
        TokenReader tokens = dict.reader("coeffs");
        return std::make_shared<Polynomial<T>>(readTerms<T>(tokens));
    }
    if (type == "expression") {
        TokenReader tokens = dict.reader("expression");
        return std::make_shared<Formula<T>>(readFormulas<T>(tokens), dict.where("expression"));
    }
    if (type == "table") {
        TokenReader tokens = dict.reader("values");
        return std::make_shared<Table1<T>>(readPairs<T>(tokens), readOutOfBounds(dict), dict.where("values"));
    }
    if (type == "tableFile")
        return std::make_shared<Table1<T>>(readTableFile<T>(dict), readOutOfBounds(dict), dict.where("file"));
    if (type == "scale")
        return std::make_shared<Scale<T>>(readFunction1<double>(dict, "scale"), readFunction1<T>(dict, "value"));
    if (type == "waveMaker") return readMakerMotion<T>(dict);
    return std::make_shared<Wave<T>>(readWave<T>(dict, type == "square"));
}

double sizeOf(double x) { return std::abs(x); }
double sizeOf(const Eigen::Vector3d& x) { return x.norm(); }

/// A derivative by differences, and by how much the function varies where they look.
template <class T>
struct Difference {
    T slope;
    double variation;
};

/// Of fourth order; forward ones next to t = 0, for formulas need not make sense before. Nothing where they would reach
/// beyond the places in which the function makes sense.
template <class T>
std::optional<Difference<T>> difference(const Function1<T>& f, double t, double step) {
    try {
        const T here = f.value(t);
        const auto change = [&](int k) { return T(f.value(t + k * step) - here); };
        const bool forward = t >= 0 && t < 2 * step;
        const T a = change(forward ? 1 : -2), b = change(forward ? 2 : -1), c = change(forward ? 3 : 1),
                d = change(forward ? 4 : 2);
        const T sum = forward ? T(48 * a - 36 * b + 16 * c - 3 * d) : T(a - 8 * b + 8 * c - d);
        return Difference<T>{sum / (12 * step), std::max({sizeOf(a), sizeOf(b), sizeOf(c), sizeOf(d)})};
    } catch (const UserError&) {
        return {};
    }
}

}  // namespace

std::vector<std::string> function1Types() {
    return {"constant", "expression", "polynomial", "scale", "sine", "square", "table", "tableFile", "waveMaker"};
}

// Nothing says how fast the function changes, in which unit of time: of steps that become shorter and shorter the one
// is taken at which two that follow each other agree best, in parts of what the function's variation there allows.
// Longer ones miss the function's turns, shorter ones drown in round-off.
template <class T>
T Function1<T>::derivative(double t) const {
    T best = 0 * value(t), last = best;
    double least = std::numeric_limits<double>::infinity();
    bool first = true;
    for (double step = 0.0314 * std::max(1.0, 1e-3 * std::abs(t)); step > 1e-13 * std::max(1e-6, std::abs(t));
         step *= 0.12) {
        const auto now = difference(*this, t, step);
        if (!now) continue;
        if (now->variation == 0) return 0 * best;
        const double doubt = first ? least : sizeOf(T(now->slope - last)) * step / now->variation;
        if (doubt < least) {
            least = doubt;
            best = now->slope;
        }
        if (least < 1e-6 && doubt > 30 * least) break;
        last = now->slope;
        first = false;
    }
    return best;
}

template <class T>
T Function1<T>::integral(double from, double to) const {
    constexpr int panels = 200;
    const double width = (to - from) / panels, gauss = 0.5 * std::sqrt(0.6) * width;
    T sum = 0 * value(from);
    for (int k = 0; k < panels; ++k) {
        const double middle = from + (k + 0.5) * width;
        sum += width / 18 * (5 * value(middle - gauss) + 8 * value(middle) + 5 * value(middle + gauss));
    }
    return sum;
}

template <class T>
Function1Ptr<T> readFunction1(const Dictionary& dict, const std::string& key) {
    return dict.isDict(key) ? readBlock<T>(dict.subDict(key)) : readInline<T>(dict, key);
}

void demandPlane(const Dictionary& dict, const std::string& key, double z) {
    if (z == 0) return;
    dict.fatal(
        key,
        fmt::format("Entry '{}' in dictionary \"{}\" has the z component {:g}: the case lies in the plane of x and y, "
                    "write (x y 0)",
                    key, dict.name(), z));
}

Function1Ptr<Eigen::Vector3d> readPlaneFunction1(const Dictionary& dict, const std::string& key) {
    auto function = readFunction1<Eigen::Vector3d>(dict, key);
    demandPlane(dict, key, function->outOfPlane());
    return function;
}

template class Function1<double>;
template class Function1<Eigen::Vector3d>;
template Function1Ptr<double> readFunction1<double>(const Dictionary&, const std::string&);
template Function1Ptr<Eigen::Vector3d> readFunction1<Eigen::Vector3d>(const Dictionary&, const std::string&);

}  // namespace pfem
