#include "mesh/wallBins.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/distance.hpp"

namespace pfem {

namespace {

template <int Dim>
struct Box {
    Vec<Dim> low, high;
};

template <int Dim>
Box<Dim> boxOf(const Face<Dim>& face, const Points<Dim>& x, const Points<Dim>& from) {
    Box<Dim> box{x[face[0]], x[face[0]]};
    for (const auto* points : {&x, &from})
        for (const int node : face) {
            box.low = box.low.cwiseMin((*points)[node]).eval();
            box.high = box.high.cwiseMax((*points)[node]).eval();
        }
    return box;
}

}  // namespace

template <int Dim>
WallBins<Dim>::WallBins(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x, const Points<Dim>& from)
    : walls_(walls), x_(x) {
    std::vector<std::pair<int, Box<Dim>>> boxes;
    for (int w = 0; w < static_cast<int>(walls.size()); ++w)
        if (walls[w].patch >= 0) boxes.emplace_back(w, boxOf<Dim>(walls[w].nodes, x, from));
    if (boxes.empty()) return;
    Box<Dim> all = boxes.front().second;
    for (const auto& [w, box] : boxes) {
        all.low = all.low.cwiseMin(box.low).eval();
        all.high = all.high.cwiseMax(box.high).eval();
    }
    // a closed surface of n squares is (n/2Dim)^(1/(Dim-1)) of them wide
    const double sides = static_cast<double>(boxes.size()) / (2 * Dim), wide = std::pow(sides, 1.0 / (Dim - 1));
    bins_.emplace(all.low, all.high, (all.high - all.low).maxCoeff() / std::clamp(wide, 1.0, 100.0));
    for (const auto& [w, box] : boxes) bins_->add(w, box.low, box.high);
}

template <int Dim>
Supports<Dim> WallBins<Dim>::supportsAt(const Vec<Dim>& point, double near) const {
    std::vector<int> found;
    forEachNear(point, point, near, [&](int w) {
        if (distanceToFace<Dim>(x_, walls_[w].nodes, point) <= near) found.push_back(w);
    });
    std::sort(found.begin(), found.end());
    Supports<Dim> supports = unsupported<Dim>();
    for (const int w : found) {
        const bool known = std::any_of(supports.begin(), supports.end(),
                                       [&](int face) { return face >= 0 && walls_[face].region == walls_[w].region; });
        if (!known) addSupport(supports, w);
    }
    return supports;
}

template class WallBins<2>;
template class WallBins<3>;

}  // namespace pfem
