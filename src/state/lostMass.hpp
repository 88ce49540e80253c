#pragma once
// The water of a node: its patch, and what that lacks.

#include <algorithm>

namespace pfem {

/// Volume of the water of a node whose patch lacks `lost` (or has -lost too much): half of the patch at least, twice
/// it at most [m2 (2D), m3].
inline double waterOf(double patch, double lost) { return std::clamp(patch + lost, 0.5 * patch, 2 * patch); }

}  // namespace pfem
