#pragma once
// Faces beside periodic sides: which of a face and its copies counts.

#include "state/images.hpp"

namespace pfem {

/// As isOwnCell: that whose node with the lowest master is no image. `id`: of all nodes.
template <int Dim>
bool isOwnFace(const std::vector<Id>& id, const Face<Dim>& face) {
    const int lowest = *std::min_element(face.begin(), face.end(),
                                         [&](int i, int j) { return id[i] % firstImage < id[j] % firstImage; });
    return id[lowest] < firstImage;
}

}  // namespace pfem
