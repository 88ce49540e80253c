#pragma once
// Which rank has which points: recursive coordinate bisection (Berger and Bokhari).

#include "base/types.hpp"

namespace pfem {

/// A box with sides along the axes; infinite where nothing bounds it.
template <int Dim>
struct Region {
    Vec<Dim> from, to;

    bool contains(const Vec<Dim>& x) const { return (x.array() >= from.array() && x.array() <= to.array()).all(); }
    Region grown(double width) const { return {from.array() - width, to.array() + width}; }
};

template <int Dim>
struct Bisection {
    std::vector<int> owner;            // per point, -1 for those that do not take part
    std::vector<Region<Dim>> regions;  // per part; they fill all space, and each holds the points of its part
};

/// Parts of equal numbers of the points that `active` names: halves across the direction in which they extend most,
/// the halves likewise. Depends on places and numbers of the points alone.
template <int Dim>
Bisection<Dim> bisect(const Points<Dim>& x, const std::vector<int>& active, int nParts);

}  // namespace pfem
