#include "mesh/locator.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
Locator<Dim>::Locator(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells) : x_(x), cells_(cells) {
    count_.fill(0);
    if (cells.empty()) return;
    Vec<Dim> high;
    low_ = high = x[cells[0][0]];
    double measure = 0;
    for (const auto& s : cells) {
        measure += std::abs(simplexMeasure<Dim>(x, s));
        for (int node : s) {
            low_ = low_.cwiseMin(x[node]);
            high = high.cwiseMax(x[node]);
        }
    }
    width_ = 1.5 * std::pow(measure / static_cast<double>(cells.size()), 1.0 / Dim);
    width_ = std::max(width_, (high - low_).maxCoeff() / 4000);  // bounds the memory
    int total = 1;
    for (int d = 0; d < Dim; ++d) {
        count_[d] = static_cast<int>((high[d] - low_[d]) / width_) + 1;
        total *= count_[d];
    }

    const auto forBins = [&](const Simplex<Dim>& s, auto&& visit) {
        Vec<Dim> a = x[s[0]], b = x[s[0]];
        for (int node : s) {
            a = a.cwiseMin(x[node]);
            b = b.cwiseMax(x[node]);
        }
        std::array<int, Dim> first, last, at;
        for (int d = 0; d < Dim; ++d) {
            first[d] = at[d] = bin(a, d);
            last[d] = bin(b, d);
        }
        for (;;) {
            int index = 0;
            for (int d = Dim - 1; d >= 0; --d) index = index * count_[d] + at[d];
            visit(index);
            int d = 0;
            while (d < Dim && ++at[d] > last[d]) {
                at[d] = first[d];
                ++d;
            }
            if (d == Dim) return;
        }
    };
    start_.assign(static_cast<std::size_t>(total) + 1, 0);
    for (const auto& s : cells)
        if (simplexMeasure<Dim>(x, s) > 0) forBins(s, [&](int b) { ++start_[b + 1]; });
    for (int b = 0; b < total; ++b) start_[b + 1] += start_[b];
    entry_.resize(start_.back());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int e = 0; e < static_cast<int>(cells.size()); ++e)
        if (simplexMeasure<Dim>(x, cells[e]) > 0) forBins(cells[e], [&](int b) { entry_[next[b]++] = e; });
}

template <int Dim>
int Locator<Dim>::bin(const Vec<Dim>& point, int axis) const {
    const double at = std::floor((point[axis] - low_[axis]) / width_);
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count_[axis] - 1)));
}

template <int Dim>
int Locator<Dim>::find(const Vec<Dim>& point) const {
    if (entry_.empty()) return -1;
    int index = 0;
    for (int d = Dim - 1; d >= 0; --d) index = index * count_[d] + bin(point, d);
    for (int s = start_[index]; s < start_[index + 1]; ++s)
        if (holds<Dim>(x_, cells_[entry_[s]], point)) return entry_[s];
    return -1;
}

template class Locator<2>;
template class Locator<3>;

}  // namespace pfem
