#pragma once
// A straight face of a rigid wall (2D).

#include "base/types.hpp"

namespace pfem {

/// A wall face as start, unit tangent, length and normal into the fluid.
struct WallLine {
    Vec<2> start, tangent, inward;
    double length;

    WallLine(const Points<2>& x, const Face<2>& face) : start(x[face[0]]), tangent(x[face[1]] - x[face[0]]) {
        length = tangent.norm();
        tangent /= length;
        inward = {-tangent[1], tangent[0]};  // fluid on the left
    }
    double along(const Vec<2>& p) const { return tangent.dot(p - start); }
    double distance(const Vec<2>& p) const { return inward.dot(p - start); }
    /// The values at the face's ends, interpolated.
    Vec<2> between(double s, const Points<2>& value, const Face<2>& face) const {
        return (1 - s / length) * value[face[0]] + s / length * value[face[1]];
    }
};

}  // namespace pfem
