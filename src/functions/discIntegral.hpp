#pragma once
// What a disc has in common with a triangle, exactly.

#include <array>

#include "base/types.hpp"

namespace pfem {

/// Area [m2] and first moments int x dA [m3].
struct AreaMoments {
    double area = 0;
    Vec<2> moment = Vec<2>::Zero();
};

/// Of the part of a triangle within the disc of radius R about the origin; negative for a triangle that turns
/// clockwise. Exact: the sum over the edges a-b of what the disc cuts out of the triangles (0 a b).
AreaMoments discPart(const std::array<Vec<2>, 3>& corners, double R);

}  // namespace pfem
