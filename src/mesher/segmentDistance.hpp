#pragma once
// Distance of points from the segments of outlines.

#include <algorithm>

#include "base/types.hpp"

namespace pfem {

/// Distance of x from the segment a-b.
inline double segmentDistance(const Vec<2>& x, const Vec<2>& a, const Vec<2>& b) {
    const Vec<2> d = b - a;
    const double s = std::clamp((x - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (a + s * d - x).norm();
}

}  // namespace pfem
