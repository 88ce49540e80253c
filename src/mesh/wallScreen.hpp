#pragma once
// Walls between points. A triangulation holds the faces of walls between near nodes on them, in the plane alone: water
// that has come over the rim of a wall would join through it what is before it.

#include <optional>

#include "mesh/topology.hpp"
#include "mesh/wallBins.hpp"

namespace pfem {

/// A point and the walls that hold it.
template <int Dim>
struct HeldPoint {
    const Vec<Dim>& x;
    const Supports<Dim>& walls;
};

template <int Dim>
class WallScreen {
public:
    /// Of h: a stream turns round the end of a wall between nodes that are about h from it.
    static constexpr double shortDetour = 2;

    /// Rigid walls that end somewhere, openings not among them, with their points at x; both must outlive it.
    WallScreen(const Topology<Dim>& topology, const Points<Dim>& x);

    /// Is the point nearer than `reach` [m] to the back of a wall that does not hold it? Only such a point can have a
    /// wall before it.
    bool hides(const HeldPoint<Dim>& point, double reach) const;

    /// The place on a wall behind which the point is, if that is the nearest face of a wall, no farther than `reach`
    /// [m] and not beside its end, as told by `detour` (of parts()).
    std::optional<WallPlace<Dim>> backAt(const HeldPoint<Dim>& point, double reach, double detour) const;

    /// Is there a wall on the straight way from one point to another one that is more than `slack` [m] behind it? Not
    /// where the way round the wall's end is longer by less than `detour` [m]: there a cell cuts its corner.
    bool parts(const HeldPoint<Dim>& from, const HeldPoint<Dim>& to, double slack, double detour) const;

private:
    bool mayHide(int wall) const;
    bool holds(int wall, const HeldPoint<Dim>& point) const;
    double distanceBefore(int wall, const HeldPoint<Dim>& point) const;
    bool isClosedAt(int wall, const Vec<Dim>& point, double near) const;
    bool isPassable(int wall, int k, const Vec<Dim>& end, const HeldPoint<Dim>& to, double detour) const;
    bool isRound(int wall, const Vec<Dim>& from, const HeldPoint<Dim>& to, double detour) const;

    const Topology<Dim>& topology_;
    const Points<Dim>& x_;
    WallBins<Dim> places_;
    std::vector<unsigned char> hasEnd_;  // per face: water may come round its wall
};

}  // namespace pfem
