#pragma once
// Which cell holds a point.

#include <optional>
#include <vector>

#include "mesh/bins.hpp"

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
    const Points<Dim>& x_;
    const std::vector<Simplex<Dim>>& cells_;
    std::optional<Bins<Dim>> bins_;  // of the cells' boxes
};

}  // namespace pfem
