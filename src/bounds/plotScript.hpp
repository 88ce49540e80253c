#pragma once
// The picture of a band as a gnuplot script.

#include <string>

#include "bounds/quantity.hpp"

namespace pfem {

/// A script that draws <name>.png from <name>.dat, both in the folder in which gnuplot runs: the bands of all
/// sizes, the limits' uncertainty, the reference, and grey where the finest band does not bracket.
std::string plotScript(const Quantity& quantity);

}  // namespace pfem
