#include "mesh/wallBins.hpp"

#include <algorithm>

#include "mesh/distance.hpp"

namespace pfem {

namespace {

/// The walls that hold somebody.
template <int Dim>
NumberedFaces<Dim> facesOf(const std::vector<WallFace<Dim>>& walls) {
    NumberedFaces<Dim> faces;
    for (int w = 0; w < static_cast<int>(walls.size()); ++w)
        if (walls[w].patch >= 0) faces.emplace_back(w, walls[w].nodes);
    return faces;
}

}  // namespace

template <int Dim>
WallBins<Dim>::WallBins(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x, const Points<Dim>& from)
    : walls_(walls), x_(x), bins_(facesOf<Dim>(walls), x, from) {}

template <int Dim>
Supports<Dim> WallBins<Dim>::supportsAt(const Vec<Dim>& point, double near) const {
    std::vector<int> found;
    forEachNear(point, point, near, [&](int w) {
        if (distanceToFace<Dim>(x_, walls_[w].nodes, point) <= near) found.push_back(w);
    });
    std::sort(found.begin(), found.end());
    Supports<Dim> supports = unsupported<Dim>();
    for (const int w : found)
        if (!isOnRegion<Dim>(walls_, supports, walls_[w].region)) addSupport(supports, w);
    return supports;
}

template class WallBins<2>;
template class WallBins<3>;

}  // namespace pfem
