#include "bounds/plotScript.hpp"

#include <fmt/format.h>

namespace pfem {

namespace {

/// Grey boxes over the times at which the band says nothing.
std::string faultBoxes(const Quantity& q) {
    std::vector<bool> faulty;
    for (const Bracket b : q.band.bracket) faulty.push_back(b != Bracket::holds && b != Bracket::none);
    std::string text;
    int n = 0;
    for (const Span& span : spansWhere(q.study.t, faulty))
        if (span.to > span.from)
            text += fmt::format(
                "set object {} rectangle from {:.8g}, graph 0 to {:.8g}, graph 1 behind fc rgb \"#e4e4e4\" "
                "fs solid noborder\n",
                ++n, span.from, span.to);
    return text;
}

/// Lines of one mesh size; the finest one is strong.
std::string twinLines(const Quantity& q, std::size_t k) {
    const bool finest = k + 1 == q.study.twins.size();
    const auto line = [&](std::size_t column, const char* word, const char* strong, const char* pale) {
        return fmt::format(", \\\n     data using 1:(v({})) with lines lw {} lc rgb \"{}\" title \"{}, h = {}\"",
                           column, finest ? "2" : "1.2 dt 2", finest ? strong : pale, word, q.study.twins[k].h);
    };
    return line(8 + 2 * k, "nodal", "#4477aa", "#99bbdd") + line(9 + 2 * k, "elemental", "#cc6677", "#ddaaaa");
}

}  // namespace

std::string plotScript(const Quantity& q) {
    std::string name;  // for an enhanced-text title
    for (const char c : q.name) name += c == '_' ? "\\\\_" : std::string(1, c);
    std::string text = fmt::format(
        "# {0}.png: the band between nodal and elemental integration. Run in this folder:  gnuplot {0}.gp\n"
        "set terminal pngcairo size 1000,640 font \"DejaVu Sans,11\" enhanced\n"
        "set output \"{0}.png\"\n"
        "v(k) = strcol(k) eq \"-\" ? NaN : column(k)\n"
        "set grid lc rgb \"#dddddd\"\n"
        "set title \"{1}: band between nodal and elemental integration (grey: no bracket)\"\n"
        "set xlabel \"time [s]\"\n"
        "set ylabel \"{1}\"\n"
        "set xrange [{2:.8g}:{3:.8g}]\n"
        "set key bottom center outside horizontal samplen 3\n",
        q.name, name, q.study.t.front(), q.study.t.back());
    text += faultBoxes(q);
    text += fmt::format("data = \"{}.dat\"\n", q.name);
    text +=
        "plot data using 1:(v(2)):(v(3)) with filledcurves fc rgb \"#eedd88\" fs transparent solid 0.6 title "
        "\"band\"";
    for (std::size_t k = 0; k < q.study.twins.size(); ++k) text += twinLines(q, k);
    if (q.limit.obstacle.empty())
        text +=
            ", \\\n     data using 1:(v(6)-v(7)):(v(6)+v(7)) with filledcurves fc rgb \"#228833\" fs "
            "transparent solid 0.3 title "
            "\"limit and uncertainty\", \\\n     data using 1:(v(6)) with lines lw 1.5 lc rgb \"#228833\" "
            "notitle";
    if (q.reference)
        text += fmt::format(", \\\n     data using 1:(v({})) with lines lw 2 lc rgb \"black\" title \"reference\"",
                            8 + 2 * q.study.twins.size());
    return text + "\n";
}

}  // namespace pfem
