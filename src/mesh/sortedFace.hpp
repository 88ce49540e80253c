#pragma once
// A face by its nodes alone, whichever side it is seen from: what sets and maps of faces need.

#include <algorithm>

#include "mesh/mesh.hpp"

namespace pfem {

template <int Dim>
Face<Dim> sorted(Face<Dim> face) {
    std::sort(face.begin(), face.end());
    return face;
}

}  // namespace pfem
