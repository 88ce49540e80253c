#pragma once
// Still water over any bottom: a body that is filled up to a level.

#include "mesher/meshDescription.hpp"

namespace pfem {

/// The parts of a body below y = level, its outline cut there: one, or as many pools as the bottom parts; the first has
/// the body's name, the others have a number behind it. Throws UserError at the entry `level` when nothing is left, and
/// for outlines with arcs or patches, which speak of vertices that are cut off.
std::vector<Body> filledUpTo(double level, const Body& body);

}  // namespace pfem
