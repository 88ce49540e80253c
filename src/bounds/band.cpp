#include "bounds/band.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

double rangeOf(const Twin& twin) {
    double low = INFINITY, high = -INFINITY;
    for (const auto* curve : {&twin.nodal, &twin.elemental})
        for (const double y : *curve) {
            if (std::isnan(y)) continue;
            low = std::min(low, y);
            high = std::max(high, y);
        }
    return high > low ? high - low : 0;
}

/// The first value that is there: the state of rest from which curves are measured.
double first(const std::vector<double>& values) {
    const auto found = std::find_if(values.begin(), values.end(), [](double y) { return !std::isnan(y); });
    return found == values.end() ? 0 : *found;
}

/// Is [n, e] inside the band of the coarser mesh, but for `slack`?
bool nested(const Twin& coarse, std::size_t i, double low, double high, double slack) {
    return low >= std::min(coarse.nodal[i], coarse.elemental[i]) - slack &&
           high <= std::max(coarse.nodal[i], coarse.elemental[i]) + slack;
}

}  // namespace

std::vector<bool> Band::where(Bracket value) const {
    std::vector<bool> flag;
    for (const Bracket b : bracket) flag.push_back(b == value);
    return flag;
}

Band makeBand(const Study& study) {
    if (study.t.size() < 2 || study.twins.empty()) throw UserError("the curves have no time in common");
    const Twin& fine = study.twins.back();
    const double restNodal = first(fine.nodal), restElemental = first(fine.elemental);
    Band band;
    band.range = rangeOf(fine);
    const double slack = narrow * band.range;
    for (std::size_t i = 0; i < study.t.size(); ++i) {
        const double n = fine.nodal[i], e = fine.elemental[i];
        band.lower.push_back(std::min(n, e));
        band.upper.push_back(std::max(n, e));
        const double toNodal = n - restNodal, toElemental = e - restElemental;
        const bool opposite = toNodal * toElemental < 0 && std::min(std::abs(toNodal), std::abs(toElemental)) > slack;
        Bracket b = Bracket::holds;
        if (std::isnan(n) || std::isnan(e))
            b = Bracket::missing;
        else if (std::abs(n - e) <= slack)
            b = Bracket::none;
        else if (opposite || std::abs(toNodal) < std::abs(toElemental))
            b = Bracket::reversed;
        else if (study.twins.size() > 1 &&
                 !nested(study.twins[study.twins.size() - 2], i, band.lower[i], band.upper[i], slack))
            b = Bracket::leaves;
        band.bracket.push_back(b);
    }
    return band;
}

std::vector<double> crossings(const Study& study, const Band& band) {
    const Twin& fine = study.twins.back();
    std::vector<double> times;
    double last = 0, when = 0;  // the last difference that was not narrow
    for (std::size_t i = 0; i < study.t.size(); ++i) {
        const double d = fine.nodal[i] - fine.elemental[i];
        if (std::isnan(d) || std::abs(d) <= narrow * band.range) continue;
        if (last * d < 0) times.push_back(when + (study.t[i] - when) * last / (last - d));
        last = d;
        when = study.t[i];
    }
    return times;
}

Width widthOf(const Study& study, const Band& band) {
    Width width;
    const auto w = weights(study.t);
    double seconds = 0;
    for (std::size_t i = 0; i < study.t.size(); ++i) {
        const double d = band.upper[i] - band.lower[i];
        if (std::isnan(d)) continue;
        width.mean += w[i] * d;
        seconds += w[i];
        if (d > width.largest) {
            width.largest = d;
            width.when = study.t[i];
        }
    }
    if (seconds > 0) width.mean /= seconds;
    return width;
}

Containment containment(const std::vector<double>& t, const Band& band, const std::vector<double>& reference,
                        double slack) {
    Containment c;
    std::vector<bool> outside, known;
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double beyond = std::max(band.lower[i] - reference[i], reference[i] - band.upper[i]);
        known.push_back(!std::isnan(reference[i]) && band.bracket[i] != Bracket::missing);
        outside.push_back(known.back() && beyond > slack);
        if (outside.back() && beyond > c.farthest) {
            c.farthest = beyond;
            c.when = t[i];
        }
    }
    c.outside = spansWhere(t, outside);
    c.compared = fractionWhere(t, known);
    c.inside = c.compared > 0 ? 1 - fractionWhere(t, outside) / c.compared : 0;
    return c;
}

}  // namespace pfem
