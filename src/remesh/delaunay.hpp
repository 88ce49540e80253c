#pragma once
// Constrained Delaunay triangulation of a point set.

#include <memory>
#include <vector>

#include "base/types.hpp"
#include "base/unset.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

template <int Dim>
struct Triangulation {
    UnsetVector<Simplex<Dim>> cells;                   // positively oriented, all of the convex hull
    UnsetVector<std::array<int, Dim + 1>> neighbours;  // opposite to local node k; -1 outside the hull
};

/// Delaunay triangulations of points that move a little from one time to the next. The result is that of a
/// triangulation from nothing, to the order of the cells: by their first nodes, the smallest of each cell, then by the
/// second (and third). What the last time has left is mended. In 2D faces constrain the triangulation; in 3D they do
/// not, and ranks share the first one.
template <int Dim>
class Triangulator {
public:
    Triangulator() : Triangulator(Ranks(), 0) {}
    /// By ranks that share the work; `halo`: of sharedDelaunay.
    Triangulator(Ranks ranks, double halo);
    ~Triangulator();
    /// A copy begins from nothing.
    Triangulator(const Triangulator& other) : Triangulator(other.ranks_, other.halo_) {}
    Triangulator& operator=(const Triangulator& other) { return *this = Triangulator(other); }
    Triangulator(Triangulator&&) noexcept;
    Triangulator& operator=(Triangulator&&) noexcept;

    /// `ids`: what the points are called, ascending; `active`: those that take part, ascending; of points that coincide
    /// one stands for all, in cells and in faces. `fixed`: faces that must appear (walls, solids). `wished`: faces that
    /// appear unless they would cross a fixed or an earlier one (free surface). Throws StepFailure when fixed faces
    /// cross each other.
    void follow(const Points<Dim>& points, const std::vector<Id>& ids, const std::vector<int>& active,
                const std::vector<Face<Dim>>& fixed, const std::vector<Face<Dim>>& wished);

    const Ranks& ranks() const { return ranks_; }

    /// Of the nPoints points followed last, until others are; to be asked for once.
    const Triangulation<Dim>& triangulation(int nPoints);

private:
    struct Kept;
    Ranks ranks_;
    double halo_ = 0;
    std::unique_ptr<Kept> kept_;
};

/// The same from nothing (2D).
Triangulation<2> constrainedDelaunay(const Points<2>& points, const std::vector<int>& active,
                                     const std::vector<Face<2>>& fixed, const std::vector<Face<2>>& wished);

}  // namespace pfem
