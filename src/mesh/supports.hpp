#pragma once
// On which walls a node lies.

#include <algorithm>
#include <array>

namespace pfem {

/// Wall faces (counted over all patches, Topology::walls) on which a node lies: up to Dim, of different regions of the
/// walls; -1 after the last. With one a node slides over a wall, with two (3D) along the edge of two.
template <int Dim>
using Supports = std::array<int, Dim>;

template <int Dim>
constexpr Supports<Dim> unsupported() {
    Supports<Dim> none{};
    for (int& face : none) face = -1;
    return none;
}

template <std::size_t N>
bool isSupported(const std::array<int, N>& supports) {
    return supports[0] >= 0;
}

template <std::size_t N>
int nSupports(const std::array<int, N>& supports) {
    return static_cast<int>(std::count_if(supports.begin(), supports.end(), [](int face) { return face >= 0; }));
}

/// Add a face at the end; nothing when there are Dim already.
template <std::size_t N>
void addSupport(std::array<int, N>& supports, int face) {
    const auto place = std::find(supports.begin(), supports.end(), -1);
    if (place != supports.end()) *place = face;
}

/// Take the face out; those after it move up.
template <std::size_t N>
void dropSupport(std::array<int, N>& supports, int face) {
    std::fill(std::remove(supports.begin(), supports.end(), face), supports.end(), -1);
}

}  // namespace pfem
