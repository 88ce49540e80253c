#pragma once
// Where walls meet.

#include <optional>

#include "mesh/topology.hpp"

namespace pfem {

/// A point on one or more walls, nearest to where it was looked for.
template <int Dim>
struct Meeting {
    Vec<Dim> x;
    Supports<Dim> walls;  // the faces of the same regions on which it lies
};

/// The place where the walls of `supports` meet, from `start` on by the least displacements to the meeting of their
/// planes; x: of the walls' points. None where they do not meet there: their planes are parallel, or one has its end
/// more than `near` [m] before (on bent walls, which bulge out of chords, by as much more).
template <int Dim>
std::optional<Meeting<Dim>> meetingOf(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x,
                                      const Supports<Dim>& supports, const Vec<Dim>& start, double near);

}  // namespace pfem
