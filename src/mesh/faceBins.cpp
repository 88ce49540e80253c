#include "mesh/faceBins.hpp"

#include <algorithm>
#include <cmath>

namespace pfem {

template <int Dim>
FaceBins<Dim>::FaceBins(const NumberedFaces<Dim>& faces, const Points<Dim>& x, const Points<Dim>& from) {
    if (faces.empty()) return;
    for (const auto& [number, face] : faces) {
        Box box{x[face[0]], x[face[0]]};
        for (const auto* points : {&x, &from})
            for (const int node : face) {
                box.low = box.low.cwiseMin((*points)[node]).eval();
                box.high = box.high.cwiseMax((*points)[node]).eval();
            }
        number_.push_back(number);
        box_.push_back(box);
    }
    Box all = box_.front();
    for (const auto& box : box_) {
        all.low = all.low.cwiseMin(box.low).eval();
        all.high = all.high.cwiseMax(box.high).eval();
    }
    // a closed surface of n squares is (n/2Dim)^(1/(Dim-1)) of them wide
    const double sides = static_cast<double>(box_.size()) / (2 * Dim), wide = std::pow(sides, 1.0 / (Dim - 1));
    bins_.emplace(all.low, all.high, (all.high - all.low).maxCoeff() / std::clamp(wide, 1.0, 100.0));
    for (int k = 0; k < static_cast<int>(box_.size()); ++k) bins_->add(k, box_[k].low, box_[k].high);
}

template class FaceBins<2>;
template class FaceBins<3>;

}  // namespace pfem
