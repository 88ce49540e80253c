#pragma once
// Where the sphere through the nodes of a tetrahedron lies, whatever the round-off.

#include <optional>

#include "base/types.hpp"

namespace pfem {

struct Ball {
    Vec<3> centre;
    double radius;
};

/// A ball that holds the sphere through the nodes of a tetrahedron, hardly larger than that [m]. None when round-off
/// hides whether the cell is upright, or when it is not.
std::optional<Ball> enclosingBall(const Points<3>& x, const Simplex<3>& cell);

}  // namespace pfem
