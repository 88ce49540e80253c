#pragma once
// What a band says, in words.

#include <string>
#include <vector>

#include "bounds/quantity.hpp"

namespace pfem {

/// A few lines on one quantity: how long it brackets, where it does not and why, the width, the largest value
/// of both curves, the estimate with its uncertainty, the reference.
std::string reportOf(const Quantity& quantity);

/// Part of the time for which the reference is inside the band or nearer to it than 1/1000 of the range; 1
/// without one.
double insideOf(const Quantity& quantity);

/// "0.1 - 0.2, 0.3 - 0.4 s"; of more than four spans the longest four, and how many there are.
std::string spansText(std::vector<Span> spans);

/// Meshes whose numbers of triangles do not go with 1/h^2 (within 25 %): their sizes are not those of all
/// bodies. Empty or a warning.
std::string unlikeMeshes(const std::vector<double>& sizes, const std::vector<int>& cells);

}  // namespace pfem
