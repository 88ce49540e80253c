#pragma once
// Order of points along Hilbert's curve: neighbours in the list are neighbours in the plane.

#include "base/types.hpp"

namespace pfem {

/// The indices of `points` in the order of the curve through their bounding square.
std::vector<int> hilbertOrder(const Points<2>& points);

}  // namespace pfem
