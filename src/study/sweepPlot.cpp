#include "study/sweepPlot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/timeFolders.hpp"

namespace pfem {

namespace {

/// A parameter's values as numbers; words are counted in the order in which they come.
struct Axis {
    std::string name;
    std::vector<double> values;
    std::vector<std::pair<std::string, double>> ticks;  // of words and of few numbers; empty: gnuplot's
    bool log = false, words = false;
};

constexpr std::size_t fewTicks = 6;

std::string quoted(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '"' || c == '\\' ? std::string("'") : std::string(1, c);
    return "\"" + safe + "\"";
}

/// 1, 2, 5, 10, ... within the values: gnuplot would give the powers of ten alone.
std::vector<std::pair<std::string, double>> logTicks(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const bool wide = *high > 1e3 * *low;
    std::vector<std::pair<std::string, double>> ticks;
    for (int power = static_cast<int>(std::floor(std::log10(*low))); std::pow(10, power) <= *high; ++power)
        for (const int digit : {1, 2, 5}) {
            const double tick = digit * std::pow(10, power);
            if (tick >= *low && tick <= *high && (digit == 1 || !wide))
                ticks.emplace_back(fmt::format("{}e{}", digit, power), tick);
        }
    return ticks;
}

Axis axisOf(const Parameter& parameter, const std::vector<SweepRow>& rows, std::size_t column) {
    Axis axis{parameter.name, {}, {}, parameter.isLog(), false};
    for (const auto& row : rows) axis.words = axis.words || !asNumber(row.theCase.values[column]);
    for (const auto& row : rows) {
        const std::string& text = row.theCase.values[column];
        auto tick = std::find_if(axis.ticks.begin(), axis.ticks.end(), [&](const auto& t) { return t.first == text; });
        if (tick == axis.ticks.end()) {
            const double place = axis.words ? static_cast<double>(axis.ticks.size()) : *asNumber(text);
            tick = axis.ticks.insert(tick, {text, place});
        }
        axis.values.push_back(tick->second);
    }
    if (axis.words || axis.ticks.size() <= fewTicks) return axis;
    axis.ticks.clear();
    if (axis.log) axis.ticks = logTicks(axis.values);
    return axis;
}

/// "parameters and results" of all cases as gnuplot's inline data.
std::string dataBlock(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows) {
    std::string text = "$data << END\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (const auto& axis : axes) text += fmt::format("{:.10g} ", axis.values[k]);
        for (const double value : rows[k].results) text += std::isnan(value) ? "NaN " : fmt::format("{:.10g} ", value);
        text += "\n";
    }
    return text + "END\n";
}

/// Of a result that no case has yet the panel is empty: gnuplot would give up without a range.
std::string heightOf(const std::vector<SweepRow>& rows, std::size_t result) {
    const bool some =
        std::any_of(rows.begin(), rows.end(), [&](const auto& r) { return !std::isnan(r.results[result]); });
    return some ? "set autoscale y\n" : "set yrange [0:1]\n";
}

/// The axis x goes a twentieth of its length beyond the values (half a word).
std::string rangeOf(const Axis& axis) {
    const auto [low, high] = std::minmax_element(axis.values.begin(), axis.values.end());
    if (*low == *high && !axis.words) return "set autoscale x\n";
    if (axis.log) {
        const double beyond = std::pow(*high / *low, 0.05);
        return fmt::format("set xrange [{:.10g}:{:.10g}]\n", *low / beyond, *high * beyond);
    }
    const double beyond = axis.words ? 0.5 : 0.05 * (*high - *low);
    return fmt::format("set xrange [{:.10g}:{:.10g}]\n", *low - beyond, *high + beyond);
}

/// Ticks and scale of the axis x, or of the colours (cb).
std::string scaleOf(const Axis& axis, const std::string& letter) {
    std::string text =
        fmt::format("set {0}label {1}\nunset logscale {0}\nset autoscale {0}\n", letter, quoted(axis.name));
    if (axis.log) text += fmt::format("set logscale {}\n", letter);
    std::string ticks;
    for (const auto& [name, place] : axis.ticks)
        ticks += fmt::format("{}{} {:.10g}", ticks.empty() ? "" : ", ", quoted(name), place);
    text +=
        ticks.empty() ? fmt::format("set {}tics autofreq\n", letter) : fmt::format("set {}tics ({})\n", letter, ticks);
    return letter == "x" ? text + rangeOf(axis) : text;
}

}  // namespace

std::string sweepPlot(const Sweep& sweep, const std::vector<SweepRow>& rows) {
    std::vector<Axis> axes;
    for (std::size_t k = 0; k < sweep.parameters.size(); ++k) axes.push_back(axisOf(sweep.parameters[k], rows, k));
    const std::size_t columns = axes.size(), lines = sweep.results.size();
    std::string text = fmt::format(
        "# The results of a study. Run in this folder:  gnuplot results.gp\n{}"
        "set terminal pngcairo size {},{} font \"DejaVu Sans,10\" noenhanced\n"
        "set output \"results.png\"\n"
        "set grid xtics ytics lt 1 lc rgb \"#cccccc\"\n"
        "set lmargin 12\nset rmargin 18\n"
        "set palette defined (0 \"#4477aa\", 0.5 \"#ddcc77\", 1 \"#cc6677\")\n"
        "unset key\nset offsets 0, 0, graph 0.05, graph 0.05\n"
        "set multiplot layout {},{}\n",
        dataBlock(axes, rows), std::max<std::size_t>(720, 560 * columns), 360 * lines, lines, columns);
    for (std::size_t r = 0; r < lines; ++r)
        for (std::size_t c = 0; c < columns; ++c) {
            const std::size_t next = (c + 1) % columns;
            text += scaleOf(axes[c], "x") + heightOf(rows, r) +
                    fmt::format("set ylabel {}\n", quoted(sweep.results[r].name));
            if (columns > 1) text += scaleOf(axes[next], "cb");
            text += fmt::format("plot $data using {}:{}{}\n", c + 1, columns + r + 1,
                                columns > 1 ? fmt::format(":{} with points pt 7 ps 1.3 lc palette", next + 1)
                                            : " with points pt 7 ps 1.3 lc rgb \"#4477aa\"");
        }
    return text + "unset multiplot\n";
}

}  // namespace pfem
