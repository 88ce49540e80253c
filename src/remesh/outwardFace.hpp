#pragma once
// Faces of tetrahedra as they are seen from outside.

#include <algorithm>

#include "mesh/simplex.hpp"

namespace pfem {

/// The outward face opposite to node k, its smallest node first.
inline Face<3> outwardFace(const Simplex<3>& cell, int k) {
    Face<3> face = oppositeFace<3>(cell, k);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

inline Face<3> turnedRound(const Face<3>& face) { return {face[0], face[2], face[1]}; }

}  // namespace pfem
