#pragma once
// Periodic sides within a step: the fluid goes on beyond them in bands of images, so that all that is done with nodes,
// cells and walls around a node finds there what it needs, where it is. Between steps, and in files, there are no more
// images than the cells that count have nodes of.

#include "mesh/wallFaces.hpp"
#include "state/images.hpp"

namespace pfem {

/// How far the bands reach, in units of the largest mesh size: residuals reach two cells, node control three.
inline constexpr double bandWidth = 5;

/// What periodic sides need to know of a case.
template <int Dim>
struct Sides {
    Period<Dim> period;
    std::vector<WallFace<Dim>> walls = {};  // as counted by Nodes::wall
    Points<Dim> points = {};                // theirs, as they were numbered and where they were
};

/// Fluid nodes (drops, too) that have left through a side come in again at the other one. Coordinates become multiples
/// of a power of two, so that images have exactly the same triangles. Returns by how many periods each has been moved.
template <int Dim>
std::vector<Shift<Dim>> comeBack(const Sides<Dim>& sides, State<Dim>& state);

/// Images of all nodes of the fluid within the bands, in the place of those that there are; cells follow.
template <int Dim>
void setImages(const Sides<Dim>& sides, State<Dim>& state);

/// Copies of the cells within the bands, after those that count. Cells that are there and do not count go.
template <int Dim>
void setCopies(const Sides<Dim>& sides, State<Dim>& state);

/// All that images have becomes their masters', at their places.
template <int Dim>
void keepImages(const Sides<Dim>& sides, State<Dim>& state);

/// The state with its bands, and without. The account of nodes that are images goes to their masters.
template <int Dim>
State<Dim> unfolded(const Sides<Dim>& sides, State<Dim> state);
template <int Dim>
State<Dim> folded(State<Dim> state);

}  // namespace pfem
