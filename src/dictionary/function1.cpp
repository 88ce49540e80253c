#include "dictionary/function1.hpp"

#include <algorithm>
#include <cmath>

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
    if (type == "scale") return std::make_shared<Scale<T>>(readFunction1<double>(dict, "scale"), readFunction1<T>(dict, "value"));
    return std::make_shared<Wave<T>>(readWave<T>(dict, type == "square"));
}

}  // namespace

std::vector<std::string> function1Types() {
    return {"constant", "expression", "polynomial", "scale", "sine", "square", "table", "tableFile"};
}

template <class T>
T Function1<T>::derivative(double t) const {
    const double step = 1e-5 * std::max(1.0, std::sqrt(std::abs(t)));
    if (t >= 0 && t < 2 * step) {  // formulas need not make sense before t = 0
        const T first = -25 * value(t) + 48 * value(t + step) - 36 * value(t + 2 * step);
        return (first + 16 * value(t + 3 * step) - 3 * value(t + 4 * step)) / (12 * step);
    }
    const T near = value(t + step) - value(t - step), far = value(t + 2 * step) - value(t - 2 * step);
    return (8 * near - far) / (12 * step);
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

template class Function1<double>;
template class Function1<Eigen::Vector3d>;
template Function1Ptr<double> readFunction1<double>(const Dictionary&, const std::string&);
template Function1Ptr<Eigen::Vector3d> readFunction1<Eigen::Vector3d>(const Dictionary&, const std::string&);

}  // namespace pfem
