#pragma once
// What a user asks for in system/meshDict: bodies of fluid and solid, rigid walls, target sizes.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/types.hpp"
#include "mesher/nature.hpp"

namespace pfem {

/// The edge between vertices `from` and `to` is the circular arc through the point `through` [m].
struct ArcEdge {
    int from = 0;
    int to = 0;
    Vec<2> through = Vec<2>::Zero();
};

/// A chain of vertices joined by straight edges or arcs: the outline of a body or the line of a wall.
struct Outline {
    std::string name;
    Points<2> points;                   // [m]
    std::vector<Location> pointPlaces;  // where each of them was written; empty: not known
    std::vector<ArcEdge> arcs;
    bool closed = true;                      // the last vertex is joined to the first
    double meshSize = 0;                     // target edge length [m]; 0: the default of the dictionary
    std::map<std::string, Location> places;  // keyword -> where it stands, for error messages

    /// Where `keyword` was written; the outline's own place ("") when it was not.
    Location at(const std::string& keyword = "") const;
    /// Where point `k` was written; if that is not known, where `keyword` was.
    Location atPoint(int k, const std::string& keyword) const;
    int nEdges() const { return static_cast<int>(points.size()) - (closed ? 0 : 1); }
};

/// unstructured: nearly equilateral triangles. The others divide a four-sided body into nx by ny cells:
/// checkerboard: the diagonal turns from cell to cell; oneWay: all alike; crossed: four triangles a cell.
enum class Pattern { unstructured, checkerboard, oneWay, crossed };

struct Body : Outline, Nature<2> {
    Pattern pattern = Pattern::unstructured;
    std::array<int, 2> cells = {0, 0};                               // along edges 0-1 and 1-2; 0: from meshSize
    std::vector<std::string> holes;                                  // bodies whose outlines are cut out of this one
    std::map<std::string, std::vector<std::array<int, 2>>> patches;  // name -> edges as pairs of vertices
    std::string group;                                               // of a mesh file: its triangles
    std::map<std::string, std::string> edgeGroups;                   // of a mesh file: patch -> group of edges
};

struct Wall : Outline {
    bool moving = false;   // it shares no node with other walls, so that it can leave them
    bool opening = false;  // the first velocity goes through it (openings.hpp)
    std::string group;     // of a mesh file: its edges; "": a line of points
};

/// A place of finer mesh: a box, or all that is near a line of points (of a sphere: its centre, twice).
struct Refinement {
    std::string name;
    bool box = true;
    Points<2> points;     // [m]; of a box: its lower left and upper right corner
    double distance = 0;  // from the line [m]
    double meshSize = 0;  // [m]
    Location where;

    /// Distance of x from the place, 0 inside [m].
    double away(const Vec<2>& x) const;
    double area() const;  // about [m2]
};

struct MeshDescription {
    double meshSize = 0;  // default target edge length [m]
    std::vector<Body> bodies;
    std::vector<Wall> walls;
    std::vector<Refinement> refinements;
    bool holdSizes = false;  // sizes belong to places, not to nodes

    std::string meshFile;                // of another program, relative to the case; "": mesh the polygons
    std::string cellArray = "material";  // of a .vtu: its groups
    double scale = 1;                    // from the file's lengths to metres
    Location meshFileAt;
};

}  // namespace pfem
