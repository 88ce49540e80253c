#pragma once
// How walls go on at their corners.

#include "mesh/topology.hpp"

namespace pfem {

/// Does the wall go on at an end of face `w` (its second node: `atEnd`) with the fluid's angle below 180 degrees?
bool isConcaveEnd(const Topology<2>& topology, const Points<2>& x, int w, bool atEnd);

}  // namespace pfem
