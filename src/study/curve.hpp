#pragma once
// Curves in time as polygons through samples; a sample that is missing (a dry probe) is NaN.

#include <vector>

namespace pfem {

struct Curve {
    std::vector<double> t, y;  // t ascending
};

/// The value at time t, linear between the samples; NaN outside of the curve and beside missing samples.
double valueAt(const Curve& curve, double t);

/// The curve at the times t.
std::vector<double> valuesAt(const Curve& curve, const std::vector<double>& t);

/// All sample times of the curves within the span that they have in common, ascending, each once. Between two
/// of them every curve is straight. Empty when the curves have no span in common.
std::vector<double> commonTimes(const std::vector<Curve>& curves);

/// Seconds for which each sample stands: half the distance between its neighbours.
std::vector<double> weights(const std::vector<double>& t);

/// A part of the time [s].
struct Span {
    double from, to;
};

/// Where `flag` holds, from sample to sample, ends half-way to the neighbours.
std::vector<Span> spansWhere(const std::vector<double>& t, const std::vector<bool>& flag);

/// Part of the whole time for which `flag` holds, 0 ... 1.
double fractionWhere(const std::vector<double>& t, const std::vector<bool>& flag);

}  // namespace pfem
