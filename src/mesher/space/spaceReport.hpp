#pragma once
// The figures that tell a good mesh of tetrahedra from a bad one.

#include "mesh/mesh.hpp"
#include "mesher/space/spaceMesher.hpp"

namespace pfem {

/// Quality of some tetrahedra.
struct TetraQuality {
    int count = 0;
    double volume = 0;                             // [m3]
    double minAngle = 180;                         // smallest angle between two faces [degrees]
    Vec<3> worst = Vec<3>::Zero();                 // the centroid of the tetrahedron with that angle
    double meanMinAngle = 0;                       // mean over tetrahedra; 70.5 is perfect
    int slivers = 0;                               // of less than 1e-2 h^3
    double shortest = 0, median = 0, longest = 0;  // edge / wanted size
};

/// Of the tetrahedra first .. last-1.
TetraQuality tetraQuality(const Nodes<3>& nodes, const Cells<3>& cells, int first, int last);

/// Table of bodies, walls and patches, with warnings about what will compute badly.
std::string spaceReport(const SpaceDescription& description, const SpaceMeshResult& result);

}  // namespace pfem
