#include "bounds/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pfem {

namespace {

/// Integral of the width over the times at which all twins have values.
std::vector<double> widths(const Study& study) {
    const auto w = weights(study.t);
    std::vector<double> sums(study.twins.size(), 0.0);
    for (std::size_t i = 0; i < study.t.size(); ++i) {
        std::vector<double> width;
        for (const Twin& twin : study.twins) width.push_back(std::abs(twin.nodal[i] - twin.elemental[i]));
        if (std::any_of(width.begin(), width.end(), [](double d) { return std::isnan(d); })) continue;
        for (std::size_t k = 0; k < width.size(); ++k) sums[k] += w[i] * width[k];
    }
    return sums;
}

struct Limits {
    double nodal, elemental;
    double mean() const { return 0.5 * (nodal + elemental); }
};

Limits limits(const Twin& coarse, const Twin& fine, std::size_t i, double order) {
    const double factor = 1 / (std::pow(coarse.h / fine.h, order) - 1);
    return {fine.nodal[i] - factor * (coarse.nodal[i] - fine.nodal[i]),
            fine.elemental[i] - factor * (coarse.elemental[i] - fine.elemental[i])};
}

}  // namespace

Estimate estimate(const Study& study, const Band& band) {
    Estimate result;
    const std::size_t n = study.twins.size();
    if (n < 2) {
        result.obstacle = "one mesh size only";
        return result;
    }
    const Twin& coarse = study.twins[n - 2];
    const Twin& fine = study.twins[n - 1];
    const auto width = widths(study);
    if (!(width[n - 1] > 0) || !(width[n - 2] > 0)) {
        result.obstacle = "the curves are the same";
        return result;
    }
    result.order = std::log(width[n - 2] / width[n - 1]) / std::log(coarse.h / fine.h);
    if (!(result.order > 0.5 && result.order < 3)) {
        result.obstacle = fmt::format(
            "the band's width goes with the mesh size to the power {:.2f}, not between 0.5 and 3: too coarse",
            result.order);
        return result;
    }
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < study.t.size(); ++i) {
        if (band.bracket[i] != Bracket::holds && band.bracket[i] != Bracket::none) {
            result.value.push_back(missing);
            result.uncertainty.push_back(missing);
            continue;
        }
        const Limits observed = limits(coarse, fine, i, result.order), formal = limits(coarse, fine, i, 2);
        const double u = observed.mean();
        double distance = 0;
        for (const double other : {observed.nodal, observed.elemental, formal.nodal, formal.elemental})
            distance = std::max(distance, std::abs(other - u));
        if (n > 2)
            distance = std::max(distance, std::abs(limits(study.twins[n - 3], coarse, i, result.order).mean() - u));
        result.value.push_back(u);
        result.uncertainty.push_back((n > 2 ? 1.25 : 3) * distance);
    }
    return result;
}

}  // namespace pfem
