#pragma once
// A surface of triangles in space with named regions: the boundary of a body, a wall, what a file holds.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/types.hpp"

namespace pfem {

struct TriSurface {
    Points<3> x;                       // [m]
    std::vector<Face<3>> triangles;    // of a closed surface: right-hand rule outwards
    std::vector<int> region;           // per triangle: index into regions
    std::vector<std::string> regions;  // xMin, side, or the solids of a file

    int size() const { return static_cast<int>(triangles.size()); }
    Vec<3> low() const;
    Vec<3> high() const;

    /// Index of the region with this name, -1 where there is none.
    int regionNamed(const std::string& name) const;

    /// Add triangles to the region with this name, which need not be there yet.
    void addRegion(const std::string& name, const std::vector<Face<3>>& faces);
};

/// Volume inside a closed surface [m3]; negative when its normals point inwards.
double volumeInside(const TriSurface& surface);

/// Area of the triangles of a region, of all with -1 [m2].
double areaOf(const TriSurface& surface, int region = -1);

}  // namespace pfem
