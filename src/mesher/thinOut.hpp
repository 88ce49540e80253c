#pragma once
// Lines with more points than the mesh size can show: which of them to keep.

#include <vector>

#include "base/types.hpp"

namespace pfem {

/// Greatest distance from the kept points' line at which a point may be left out / mesh size.
inline constexpr double thinOutTolerance = 0.05;

/// Per point of the line: whether it is kept. `h`: the mesh size there [m]. Only points at edges shorter than half of
/// it are left out: those that lie within `thinOutTolerance` of the straight line between kept ones. Of dense ones on a
/// curve about one per h is kept. The ends are kept; of a closed line (the last point is the first) three at least.
std::vector<bool> thinOut(const Points<2>& x, const std::vector<double>& h);

/// Whether the edges from point k to k+1 are short, or next to a short one: only between these may points be left out.
std::vector<bool> denseEdges(const Points<2>& x, const std::vector<double>& h);

/// Length of the line through those points that are needed to stay within `tolerance` of all [m].
double lengthWithin(const Points<2>& x, double tolerance);

}  // namespace pfem
