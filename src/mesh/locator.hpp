#pragma once
// Which cell holds a point: uniform bins over the cells' boxes.

#include <vector>

#include "base/types.hpp"

namespace pfem {

template <int Dim>
class Locator {
public:
    /// Copies nothing: `x` and `cells` must outlive the locator. Inverted cells are left out.
    Locator(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells);

    /// Index of the first cell that holds the point (boundary included) or -1.
    int find(const Vec<Dim>& point) const;

    bool contains(const Vec<Dim>& point) const { return find(point) >= 0; }

private:
    int bin(const Vec<Dim>& point, int axis) const;

    const Points<Dim>& x_;
    const std::vector<Simplex<Dim>>& cells_;
    Vec<Dim> low_ = Vec<Dim>::Zero();
    double width_ = 1;
    std::array<int, Dim> count_{};
    std::vector<int> start_;
    std::vector<int> entry_;
};

}  // namespace pfem
