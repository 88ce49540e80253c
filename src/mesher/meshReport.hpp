#pragma once
// The figures that tell a good mesh from a bad one.

#include <string>

#include "mesher/mesher.hpp"

namespace pfem {

/// Quality of some triangles.
struct TriangleQuality {
    int count = 0;
    double area = 0;                               // [m2]
    double minAngle = 180;                         // [degrees]
    Vec<2> worst = Vec<2>::Zero();                 // a corner of the triangle with that angle
    double meanMinAngle = 0;                       // mean over triangles of the smallest angle; 60 is perfect
    double shortest = 0, median = 0, longest = 0;  // edge / wanted size
};

/// Of the triangles first .. last-1.
TriangleQuality triangleQuality(const Nodes<2>& nodes, const Cells<2>& cells, int first, int last);

/// Fluid triangles whose three nodes all lie on walls: no free node can carry their pressure.
std::vector<int> wallTriangles(const State<2>& state);

/// Table of bodies, walls and patches, with warnings about what will compute badly.
std::string meshReport(const MeshDescription& description, const MeshResult& result);

}  // namespace pfem
