#include "remesh/pointGrid.hpp"

#include <cmath>

#include "base/parallel.hpp"

namespace pfem {

PointGrid::PointGrid(const Points<3>& x, const std::vector<int>& active, const PointBox& whole, double width)
    : low_(whole.low) {
    constexpr double boxesPerPoint = 16;
    const int n = static_cast<int>(active.size());
    const Vec<3> size = (whole.high - low_).array() + width;
    const double taken = std::max({width, std::cbrt(size.prod() / (boxesPerPoint * (n + 1))), 1e-6 * size.maxCoeff()});
    if (taken > 0) boxesPerLength_ = 1 / taken;
    for (int d = 0; d < 3; ++d) count_[d] = static_cast<int>((whole.high[d] - low_[d]) * boxesPerLength_) + 1;
    std::vector<int> box(n);
    parallelFor(n, [&](int k) { box[k] = number(boxOf(x[active[k]])); });
    start_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (const int b : box) ++start_[b + 1];
    for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
    std::vector<int> next(start_.begin(), start_.end() - 1);
    places_.resize(n);
    for (int k = 0; k < n; ++k) places_[next[box[k]]++] = {x[active[k]], active[k]};
}

bool PointGrid::coincide() const {
    const int nBoxes = static_cast<int>(start_.size()) - 1;
    return parallelFirst(nBoxes, [&](int b) {
               for (int p = start_[b]; p < start_[b + 1]; ++p)
                   for (int q = start_[b]; q < p; ++q)
                       if (places_[p].x == places_[q].x) return true;
               return false;
           }) < nBoxes;
}

}  // namespace pfem
