#pragma once
// Whole numbers from lengths. 0.3/0.04 is 7.5 in metres and may be 7.499... in other units: where round-off would
// decide, a rule does, so that a case has the same mesh in all units of length.

#include <cmath>

namespace pfem {

/// A part of a length that round-off alone can make.
inline constexpr double lengthRoundOff = 1e-9;

/// The nearest whole number, a half upwards; at least 1.
inline int nearestCount(double x) { return x < 1 ? 1 : static_cast<int>(std::floor(x * (1 + lengthRoundOff) + 0.5)); }

/// The next whole number upwards, x itself when it is one.
inline int countAbove(double x) { return static_cast<int>(std::ceil(x * (1 - lengthRoundOff))); }

}  // namespace pfem
