#pragma once
// Which walls are at a place: found by bins, for walls with thousands of faces.

#include <vector>

#include "mesh/faceBins.hpp"
#include "mesh/wallFaces.hpp"

namespace pfem {

template <int Dim>
class WallBins {
public:
    /// Of walls whose points are at x; both must outlive it. With `from`: a face is found wherever its points come by
    /// on their ways from there.
    WallBins(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x, const Points<Dim>& from);
    WallBins(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x) : WallBins(walls, x, x) {}

    /// f(face) for all faces of walls that may come within `radius` of the box from `low` to `high`; some come several
    /// times.
    template <class F>
    void forEachNear(const Vec<Dim>& low, const Vec<Dim>& high, double radius, F&& f) const {
        bins_.forEachNear(low, high, radius, f);
    }

    /// One face of each region that comes within `near` [m] of a point, the first; in the order of the faces.
    Supports<Dim> supportsAt(const Vec<Dim>& point, double near) const;

private:
    const std::vector<WallFace<Dim>>& walls_;
    const Points<Dim>& x_;
    FaceBins<Dim> bins_;
};

}  // namespace pfem
