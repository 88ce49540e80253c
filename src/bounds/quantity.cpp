#include "bounds/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/table.hpp"

namespace pfem {

namespace {

const Curve* find(const std::vector<ProbeHistory>& histories, const std::string& name) {
    for (const ProbeHistory& history : histories)
        if (history.name == name) return &history.curve;
    return nullptr;
}

bool isConstant(const Curve& curve) {
    return std::all_of(curve.y.begin(), curve.y.end(), [&](double y) { return y == curve.y.front() || std::isnan(y); });
}

/// The curve of every size, all nodal ones first; empty if one does not have it or all are constant.
std::vector<Curve> curvesOf(const std::vector<TwinHistories>& twins, const std::string& name) {
    std::vector<Curve> curves;
    for (const auto member : {&TwinHistories::nodal, &TwinHistories::elemental})
        for (const auto& twin : twins) {
            const Curve* curve = find(twin.*member, name);
            if (!curve) return {};
            curves.push_back(*curve);
        }
    if (std::all_of(curves.begin(), curves.end(), isConstant)) return {};
    return curves;
}

}  // namespace

std::vector<Quantity> quantitiesOf(const std::string& function, const std::vector<TwinHistories>& twins,
                                   const std::vector<ProbeHistory>& reference, std::optional<double> until) {
    std::vector<Quantity> quantities;
    for (const ProbeHistory& history : twins.front().nodal) {
        const auto curves = curvesOf(twins, history.name);
        if (curves.empty()) continue;
        Quantity q;
        q.name = function + "_" + history.name;
        q.study.t = commonTimes(curves);
        if (until) std::erase_if(q.study.t, [&](double t) { return t > *until * (1 + 1e-9); });
        for (std::size_t k = 0; k < twins.size(); ++k)
            q.study.twins.push_back(
                {twins[k].h, valuesAt(curves[k], q.study.t), valuesAt(curves[twins.size() + k], q.study.t)});
        q.band = makeBand(q.study);
        q.limit = estimate(q.study, q.band);
        if (const Curve* curve = find(reference, history.name)) q.reference = valuesAt(*curve, q.study.t);
        quantities.push_back(std::move(q));
    }
    return quantities;
}

void writeQuantity(const std::filesystem::path& folder, const Quantity& q, int precision) {
    Table table(folder / (q.name + ".dat"), precision);
    table.comment(q.name + ": the finest mesh's band between nodal and elemental integration");
    table.comment(
        "bracket: 1 holds, 0 narrower than 1/1000 of the range, -1 order reversed, -2 leaves the coarser "
        "band, "
        "-9 missing");
    std::vector<std::string> titles{"Time", "lower", "upper", "width", "bracket", "estimate", "uncertainty"};
    for (const Twin& twin : q.study.twins)
        for (const char* integration : {"nodal", "elemental"})
            titles.push_back(fmt::format("{}_{}", integration, twin.h));
    if (q.reference) titles.emplace_back("reference");
    table.header(titles);
    const auto number = [&](double y) { return std::isnan(y) ? std::string("-") : table.number(y); };
    for (std::size_t i = 0; i < q.study.t.size(); ++i) {
        std::vector<std::string> row{table.number(q.study.t[i]), number(q.band.lower[i]), number(q.band.upper[i]),
                                     number(q.band.upper[i] - q.band.lower[i]),
                                     std::to_string(static_cast<int>(q.band.bracket[i]))};
        for (const auto* values : {&q.limit.value, &q.limit.uncertainty})
            row.push_back(values->empty() ? "-" : number((*values)[i]));
        for (const Twin& twin : q.study.twins)
            for (const double y : {twin.nodal[i], twin.elemental[i]}) row.push_back(number(y));
        if (q.reference) row.push_back(number((*q.reference)[i]));
        table.row(row);
    }
}

}  // namespace pfem
