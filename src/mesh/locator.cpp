#include "mesh/locator.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
Locator<Dim>::Locator(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells) : x_(x), cells_(cells) {
    if (cells.empty()) return;
    Vec<Dim> low = x[cells[0][0]], high = low;
    double measure = 0;
    for (const auto& s : cells) {
        measure += std::abs(simplexMeasure<Dim>(x, s));
        for (int node : s) {
            low = low.cwiseMin(x[node]);
            high = high.cwiseMax(x[node]);
        }
    }
    bins_.emplace(low, high, 1.5 * std::pow(measure / static_cast<double>(cells.size()), 1.0 / Dim));
    for (int e = 0; e < static_cast<int>(cells.size()); ++e) {
        if (!(simplexMeasure<Dim>(x, cells[e]) > 0)) continue;
        Vec<Dim> a = x[cells[e][0]], b = a;
        for (int node : cells[e]) {
            a = a.cwiseMin(x[node]);
            b = b.cwiseMax(x[node]);
        }
        bins_->add(e, a, b);
    }
}

template <int Dim>
int Locator<Dim>::find(const Vec<Dim>& point) const {
    int found = -1;
    if (bins_)
        bins_->any(point, point, [&](int e) {
            if (!holds<Dim>(x_, cells_[e], point)) return false;
            found = e;
            return true;
        });
    return found;
}

template class Locator<2>;
template class Locator<3>;

}  // namespace pfem
