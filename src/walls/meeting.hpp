#pragma once
// Where two walls meet.

#include <optional>

#include "mesh/topology.hpp"

namespace pfem {

/// The place of two wall faces where a node lies on both, within the faces (to `slack`); none where they do not meet.
std::optional<Vec<2>> meetingOf(const Topology<2>& topology, const Points<2>& x, int wall, int other, double slack);

/// Do two wall faces have a common end with a convex bend?
bool isConvexEnd(const Topology<2>& topology, int wall, int other);

}  // namespace pfem
