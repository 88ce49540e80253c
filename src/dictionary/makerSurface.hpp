#pragma once
// The surface that a wave maker wants.

#include <functional>

#include "dictionary/dictionary.hpp"

namespace pfem {

/// Of entries with `type waveMaker`: height of the surface at the piston over the still level, over time [m], for a
/// scale of 1 into the water. UserError for another maker.
std::function<double(double)> readMakerSurface(const Dictionary& dict);

}  // namespace pfem
