#include "bounds/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pfem {

namespace {

constexpr double wide = 0.5;  // mean width, in parts of the range, beyond which a band says little

/// "  reversed for 12 % of the time (0.3 - 0.34 s): why", or nothing.
std::string fault(const Quantity& q, Bracket bracket, const char* why) {
    const auto flag = q.band.where(bracket);
    const double part = fractionWhere(q.study.t, flag);
    if (part == 0) return "";
    return fmt::format("    NO BRACKET for {:.3g} % of the time ({}): {}\n", 100 * part,
                       spansText(spansWhere(q.study.t, flag)), why);
}

/// Largest deviation from the first value of one finest curve, and when.
std::string peakText(const Quantity& q, const std::vector<double>& values, const char* name) {
    std::size_t k = 0;
    double farthest = -1;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::abs(values[i] - values.front()) > farthest) {
            farthest = std::abs(values[i] - values.front());
            k = i;
        }
    return fmt::format("{} {:.5g} at {:.4g} s", name, values[k], q.study.t[k]);
}

std::string estimateText(const Quantity& q) {
    if (!q.limit.obstacle.empty()) return "    no estimate: " + q.limit.obstacle + "\n";
    const auto w = weights(q.study.t);
    double sum = 0, seconds = 0, farthest = -1;
    std::size_t k = 0;
    for (std::size_t i = 0; i < q.study.t.size(); ++i) {
        if (std::isnan(q.limit.value[i])) continue;
        sum += w[i] * q.limit.uncertainty[i];
        seconds += w[i];
        const double away = std::abs(q.limit.value[i] - q.study.twins.back().nodal.front());
        if (away > farthest) {
            farthest = away;
            k = i;
        }
    }
    if (!(seconds > 0)) return "    no estimate: the band holds nowhere\n";
    return fmt::format(
        "    limit for h -> 0: order {:.2f}; largest {:.5g} +- {:.2g} at {:.4g} s; mean uncertainty {:.3g}\n",
        q.limit.order, q.limit.value[k], q.limit.uncertainty[k], q.study.t[k], sum / seconds);
}

std::string referenceText(const Quantity& q) {
    if (!q.reference) return "";
    const double slack = narrow * q.band.range;
    const auto c = containment(q.study.t, q.band, *q.reference, slack);
    if (c.compared == 0) return "    the reference has no values at these times\n";
    std::string text = fmt::format(
        "    the reference is inside the band, or within 1/1000 of the range ({:.2g}), for {:.1f} % of the "
        "time; inside to the last digit {:.1f} %\n",
        slack, 100 * c.inside, 100 * containment(q.study.t, q.band, *q.reference).inside);
    if (!c.outside.empty())
        text +=
            fmt::format("    outside by at most {:.3g} at {:.4g} s: {}\n", c.farthest, c.when, spansText(c.outside));
    return text;
}

}  // namespace

double insideOf(const Quantity& q) {
    return q.reference ? containment(q.study.t, q.band, *q.reference, narrow * q.band.range).inside : 1;
}

std::string spansText(std::vector<Span> spans) {
    const std::size_t total = spans.size();
    const auto longer = [](const Span& a, const Span& b) { return a.to - a.from > b.to - b.from; };
    std::stable_sort(spans.begin(), spans.end(), longer);
    if (spans.size() > 4) spans.resize(4);
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
    std::string text;
    for (const Span& span : spans)
        text += fmt::format("{}{:.4g} - {:.4g}", text.empty() ? "" : ", ", span.from, span.to);
    return text + " s" + (total > 4 ? fmt::format("; {} spans in all", total) : "");
}

std::string reportOf(const Quantity& q) {
    const Twin& fine = q.study.twins.back();
    const Width width = widthOf(q.study, q.band);
    const double holds = fractionWhere(q.study.t, q.band.where(Bracket::holds));
    std::string text =
        fmt::format("{}, mesh size {}, {:.4g} - {:.4g} s\n", q.name, fine.h, q.study.t.front(), q.study.t.back());
    text += fmt::format(
        "    nodal and elemental bracket for {:.1f} % of the time; nearer to each other than 1/1000 of the "
        "range "
        "for {:.1f} %\n",
        100 * holds, 100 * fractionWhere(q.study.t, q.band.where(Bracket::none)));
    text +=
        fault(q, Bracket::reversed, "the nodal curve is not the one farther from the start: the curves have crossed");
    text += fault(q, Bracket::leaves, "the band leaves the one of the coarser mesh: too coarse");
    text += fault(q, Bracket::missing, "a curve has no value");
    if (const auto times = crossings(q.study, q.band); !times.empty())
        text += fmt::format(
            "    the curves cross {} times, first at {:.4g} s: around a crossing a thin band is no sign of "
            "accuracy\n",
            times.size(), times.front());
    text += "    farthest from the start: " + peakText(q, fine.nodal, "nodal") + ", " +
            peakText(q, fine.elemental, "elemental") + "\n";
    text +=
        fmt::format("    width: mean {:.3g}, largest {:.3g} at {:.4g} s; mean {:.0f} % of the range of the curves{}\n",
                    width.mean, width.largest, width.when, q.band.range > 0 ? 100 * width.mean / q.band.range : 0,
                    width.mean > wide * q.band.range ? ": TOO COARSE to say much" : "");
    return text + estimateText(q) + referenceText(q);
}

std::string unlikeMeshes(const std::vector<double>& sizes, const std::vector<int>& cells) {
    for (std::size_t k = 1; k < sizes.size(); ++k) {
        const double wanted = std::pow(sizes[k - 1] / sizes[k], 2),
                     found = static_cast<double>(cells[k]) / cells[k - 1];
        if (found < wanted / 1.25 || found > 1.25 * wanted)
            return fmt::format(
                "from mesh size {} to {} the triangles become {:.2f} times as many, not {:.2f}: do bodies "
                "have a "
                "meshSize or cells of their own? The order and the estimate are then not to be trusted",
                sizes[k - 1], sizes[k], found, wanted);
    }
    return "";
}

}  // namespace pfem
