#pragma once
// Which of many points lie in a mesh.

#include <vector>

#include "base/types.hpp"

namespace pfem {

/// Per point: is it in one of the cells, boundary included? Inverted cells hold nothing.
template <int Dim>
std::vector<unsigned char> heldPoints(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells,
                                      const Points<Dim>& points);

}  // namespace pfem
