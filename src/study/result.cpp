#include "study/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/history.hpp"

namespace pfem {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The samples up to a time that have a value.
Curve known(const Curve& curve, double until) {
    Curve part;
    for (std::size_t i = 0; i < curve.t.size(); ++i)
        if (curve.t[i] <= until && !std::isnan(curve.y[i])) {
            part.t.push_back(curve.t[i]);
            part.y.push_back(curve.y[i]);
        }
    return part;
}

double mean(const Curve& curve) {
    if (curve.t.size() == 1) return curve.y[0];
    const auto w = weights(curve.t);
    double sum = 0;
    for (std::size_t i = 0; i < w.size(); ++i) sum += w[i] * curve.y[i];
    return sum / (curve.t.back() - curve.t.front());
}

/// The word itself, or the only one there is when it was left out.
std::string chosen(const Result& result, const char* key, const std::string& word,
                   const std::vector<std::string>& valid) {
    if (word.empty() && valid.size() == 1) return valid.front();
    if (std::find(valid.begin(), valid.end(), word) != valid.end()) return word;
    const std::string text =
        word.empty() ? fmt::format("needs an entry '{}'. Valid are:", key) : notValid(word, key, valid);
    std::string list;
    if (word.empty())
        for (const auto& name : valid) list += " " + name;
    throw UserError(fmt::format("result '{}': {}{}", result.name, text, list), result.where);
}

}  // namespace

Result readResult(const Dictionary& dict) {
    Result result;
    result.name = dict.keyword();
    result.where = dict.where();
    readEntries(dict, static_cast<ResultEntries&>(result));
    if (dict.found("time") != (result.value == "at"))
        throw UserError(fmt::format("result '{}': 'time' and 'value at;' go together", result.name), result.where);
    return result;
}

double valueOf(const Result& result, const Curve& curve, double until) {
    if (result.value == "at") return valueAt(curve, result.time);
    const Curve part = known(curve, until);
    if (part.t.empty()) return missing;
    if (result.value == "mean") return mean(part);
    if (result.value == "last") return part.y.back();
    const bool largest = result.value == "max" || result.value == "timeOfMax";
    const auto best =
        largest ? std::max_element(part.y.begin(), part.y.end()) : std::min_element(part.y.begin(), part.y.end());
    return result.value.starts_with("timeOf") ? part.t[static_cast<std::size_t>(best - part.y.begin())] : *best;
}

double valueIn(const Result& result, const std::filesystem::path& root, double until) {
    const auto file = chosen(result, "file", result.file, historyFiles(root, result.function));
    const auto histories = readHistories(root, result.function, file);
    std::vector<std::string> columns;
    for (const auto& history : histories) columns.push_back(history.name);
    const auto column = chosen(result, "column", result.column, columns);
    const auto found = std::find(columns.begin(), columns.end(), column);
    return valueOf(result, histories[static_cast<std::size_t>(found - columns.begin())].curve, until);
}

}  // namespace pfem
