#include "study/sampling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "case/timeFolders.hpp"

namespace pfem {

namespace {

using Table = std::vector<std::vector<std::string>>;

constexpr std::size_t mostCases = 100000;

/// The values that a parameter takes in a grid or list: its own, or `count` of its range, both ends included.
std::vector<std::string> axisOf(const Parameter& parameter) {
    if (!parameter.values.empty()) return parameter.values;
    if (parameter.count < 2)
        throw UserError(fmt::format("parameter '{}': grid and list need values, or count (2 or more) with the range",
                                    parameter.name),
                        parameter.where);
    std::vector<std::string> axis;
    for (int i = 0; i < parameter.count; ++i)
        axis.push_back(fmt::format("{:.8g}", parameter.at(static_cast<double>(i) / (parameter.count - 1))));
    return axis;
}

Table grid(const Sweep& sweep) {
    Table table{{}};
    for (const auto& parameter : sweep.parameters) {
        Table longer;
        for (const auto& row : table)
            for (const auto& value : axisOf(parameter)) {
                longer.push_back(row);
                longer.back().push_back(value);
                if (longer.size() > mostCases)
                    throw UserError(fmt::format("more than {} cases", mostCases), sweep.where);
            }
        table = std::move(longer);
    }
    return table;
}

Table list(const Sweep& sweep) {
    Table table(axisOf(sweep.parameters.front()).size());
    for (const auto& parameter : sweep.parameters) {
        const auto axis = axisOf(parameter);
        if (axis.size() != table.size())
            throw UserError(fmt::format("method list: '{}' has {} values, '{}' has {}", sweep.parameters.front().name,
                                        table.size(), parameter.name, axis.size()),
                            parameter.where);
        for (std::size_t k = 0; k < axis.size(); ++k) table[k].push_back(axis[k]);
    }
    return table;
}

/// Random numbers of our own making from the standard's generator: its distributions differ between libraries.
class Random {
public:
    explicit Random(int seed) : bits_(static_cast<std::uint64_t>(seed)) {}

    /// 0 <= number < 1, all 53 bits.
    double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

    std::vector<int> permutation(int n) {
        std::vector<int> order(static_cast<std::size_t>(n));
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[static_cast<std::size_t>(unit() * static_cast<double>(i))]);
        return order;
    }

private:
    std::mt19937_64 bits_;
};

/// The value in part `k` of `n`, with as few digits as leave it there, but at least six.
std::string valueInPart(const Parameter& parameter, int k, int n, double offset) {
    const double part = (k + offset) / n;
    if (!parameter.values.empty()) {
        const auto m = parameter.values.size();
        return parameter.values[std::min(m - 1, static_cast<std::size_t>(part * static_cast<double>(m)))];
    }
    for (int digits = 6; digits < 17; ++digits) {
        std::string text = fmt::format("{:.{}g}", parameter.at(part), digits);
        const double place = n * parameter.partOf(*asNumber(text));
        if (place > k && place < k + 1) return text;
    }
    return fmt::format("{:.17g}", parameter.at(part));
}

Table latinHypercube(const Sweep& sweep) {
    Random random(sweep.seed);
    Table table(static_cast<std::size_t>(sweep.samples));
    for (const auto& parameter : sweep.parameters) {
        const auto order = random.permutation(sweep.samples);
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i].push_back(valueInPart(parameter, order[i], sweep.samples, random.unit()));
    }
    return table;
}

}  // namespace

std::vector<std::vector<std::string>> sampleCases(const Sweep& sweep) {
    if (sweep.method == "grid") return grid(sweep);
    return sweep.method == "list" ? list(sweep) : latinHypercube(sweep);
}

}  // namespace pfem
