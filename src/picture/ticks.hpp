#pragma once
// Numbers on a scale: round, few, and written short.

#include <string>
#include <vector>

namespace pfem {

/// Multiples of 1, 2, 2.5 or 5 times a power of ten inside [low, high], about `wanted` of them.
std::vector<double> roundTicks(double low, double high, int wanted);

/// At most 6 significant digits; what is round-off beside `scale` is 0.
std::string tickLabel(double value, double scale);

}  // namespace pfem
