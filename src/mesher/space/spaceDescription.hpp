#pragma once
// What a user asks for in system/meshDict of a case in space: shapes, bodies and walls made of them, sizes.

#include <map>
#include <optional>

#include "mesh/triSurface.hpp"
#include "mesher/nature.hpp"
#include "mesher/space/spaceDomain.hpp"

namespace pfem {

/// Keyword -> where it stands; "": the dictionary itself.
struct Places : std::map<std::string, Location> {
    Places() = default;
    explicit Places(const Dictionary& dict);
    Location of(const std::string& keyword = "") const;
};

struct Geometry {
    std::string name;
    TriSurface surface;
    std::string file;  // of a triSurfaceMesh
    bool scaled = false;
    bool closed = true;
    Places places;
};

/// A part of a body's surface: regions of shapes, and what lies in a box.
struct FaceSelection {
    std::vector<std::pair<int, int>> regions;  // geometry and its region; -1: all of it
    std::optional<std::array<Vec<3>, 2>> box;
    Places places;
};

struct SpaceBody : Nature<3> {
    std::string name;
    double meshSize = 0;  // target edge length [m]
    BodySpace space;      // of geometries
    std::map<std::string, FaceSelection> patches;
    std::string group;                              // of a mesh file: its tetrahedra
    std::map<std::string, std::string> faceGroups;  // of a mesh file: patch -> group of triangles
    Places places;
};

/// Which side of a wall's surface the fluid is on.
enum class WallSide { automatic, inside, outside };

struct SpaceWall {
    std::string name;
    int geometry = -1;
    std::vector<bool> open;  // per region of the geometry: left out
    WallSide side = WallSide::automatic;
    bool moving = false;
    bool opening = false;  // the first velocity goes through it (../openings.hpp)
    std::string group;     // of a mesh file: its triangles
    Places places;
};

struct SpaceRefinement {
    enum class Type { box, sphere, surface };
    std::string name;
    Type type = Type::box;
    Vec<3> low = Vec<3>::Zero(), high = Vec<3>::Zero();  // of a box
    Vec<3> centre = Vec<3>::Zero();
    double radius = 0;
    int geometry = -1;
    double distance = 0;  // how far from the surface the size holds [m]
    double meshSize = 0;  // [m]
    Places places;
};

struct SpaceDescription {
    double meshSize = 0;  // default target edge length [m]
    std::vector<Geometry> geometries;
    std::vector<SpaceBody> bodies;
    std::vector<SpaceWall> walls;
    std::vector<SpaceRefinement> refinements;
    bool holdSizes = false;              // sizes belong to places, not to nodes
    std::string meshFile;                // of another program, relative to the case; "": mesh the shapes
    std::string cellArray = "material";  // of a .vtu: its groups
    double scale = 1;                    // from the mesh file's lengths to metres
    Places places;

    double sizeOf(const SpaceBody& body) const { return body.meshSize > 0 ? body.meshSize : meshSize; }
    std::vector<std::string> geometryNames() const;
    int geometryNamed(const std::string& name) const;
};

}  // namespace pfem
