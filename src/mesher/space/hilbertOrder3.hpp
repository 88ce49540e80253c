#pragma once
// Points in space in the order of Hilbert's curve: what is near in space is near in memory.

#include "base/types.hpp"

namespace pfem {

/// Indices of the points along the curve.
std::vector<int> hilbertOrder3(const Points<3>& points);

}  // namespace pfem
