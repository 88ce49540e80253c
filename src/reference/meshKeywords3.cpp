#include "reference/meshEntries.hpp"

namespace pfem {

// What mesher/space/readSpaceDict.cpp and readGeometry.cpp read; a test compares the names.
std::vector<KeywordTable> spaceMeshKeywords() {
    const std::string file = "system/meshDict";
    using namespace meshEntries;
    return {
        {file,
         "in space: geometry: each",
         "Three dimensions: shapes in OpenFOAM's words. Bodies and walls are made of them. Their faces have names: "
         "xMin "
         "... zMax of a box; side, end1, end2 of a cylinder or cone; edge0, edge1, ..., start, end of an extruded "
         "polygon; the solids or groups of a file.",
         {{"type", "word", "-", "required", "what it is; triSurfaceMesh: a file",
           "one of: box cylinder cone sphere plane disk extrude triSurfaceMesh"},
          {"name", "word", "-", "the keyword", "another name", ""},
          {"min", "point", "m", "required", "of a box: its lowest corner", ""},
          {"max", "point", "m", "required", "of a box: its highest corner", ""},
          {"point1", "point", "m", "required", "of a cylinder or cone: the centre of one end", ""},
          {"point2", "point", "m", "required", "of a cylinder or cone: the centre of the other end", ""},
          {"radius", "scalar", "m", "required", "of a cylinder, sphere or disk", "> 0"},
          {"radius1", "scalar", "m", "required", "of a cone at point1", ">= 0"},
          {"radius2", "scalar", "m", "required", "of a cone at point2", ">= 0"},
          {"centre", "point", "m", "required", "of a sphere or disk; also: origin", ""},
          {"origin", "point", "m", "required", "of a sphere or disk: its centre", ""},
          {"point", "point", "m", "required", "of a plane: the middle of its square; also: basePoint", ""},
          {"basePoint", "point", "m", "required", "of a plane: the same as point", ""},
          {"normal", "point", "-", "required", "of a plane or disk; of a plane also: normalVector", ""},
          {"normalVector", "point", "-", "required", "of a plane: the same as normal", ""},
          {"side", "scalar", "m", "required", "of a plane: length of its square's sides", "> 0"},
          {"segments", "int", "-", "by meshSize", "of a round shape: facets round it; facets are half of meshSize wide",
           "from 3 to 10000"},
          {"vertices", "list of points", "m", "required",
           "of extrude: a polygon (x y), counter-clockwise; with an axis (x r), (r y) or (r z)", ""},
          arcs("of extrude: "),
          {"height", "scalar", "m", "required", "of extrude: along z; negative: downwards", ""},
          {"direction", "point", "m", "along z", "of extrude, instead of height: where the other end is", ""},
          {"from", "scalar", "m", "0", "of extrude: z of the first end", ""},
          {"axis", "word", "-", "none", "of extrude: turn the polygon round it instead", "one of: x y z"},
          {"angle", "scalar", "degrees", "360", "of extrude with an axis: how far it is turned", "from 0 to 360"},
          {"file", "file", "-", "the keyword",
           "of triSurfaceMesh: STL (text or binary), OBJ, OFF or VTP, relative to the case or to constant/triSurface",
           ""},
          {"scale", "scalar", "-", "1", "of triSurfaceMesh: from the file's lengths to metres", "> 0"},
          {"includedAngle", "scalar", "degrees", "none",
           "of triSurfaceMesh: divide its faces where they include less than this, as surfaceFeatures: name_0, name_1, "
           "...",
           ""}}},
        {file, "in space: bodies: each", "Bodies that touch share their nodes.",
         joined(bodyRows(), {{"geometry", "words", "-", "required",
                              "a closed shape or a list of them, of which the body is the union; or a shape here: "
                              "geometry { type box; "
                              "... }",
                              ""},
                             {"subtract", "words", "-", "()", "shapes that are cut out", ""},
                             {"intersect", "words", "-", "()", "shapes within which the body is kept", ""},
                             size("tetrahedra's"),
                             velocity("(0 0 0)", "\"-2*y\" \"2*x\" \"0\""),
                             group("body", "geometry", "tetrahedra"),
                             patches("surface")})},
        {file,
         "in space: bodies: patches: each",
         "A part of the body's surface.",
         {{"faces", "words", "-", "required",
           "faces of its shapes: zMin, or pier.zMin where several have one; or a whole "
           "shape",
           ""},
          {"box", "two points", "m", "optional", "and what lies in it: box (0 0 0) (1 1 0)", ""},
          group("patch", "faces", "triangles")}},
        {file,
         "in space: walls: each",
         "A shape from its fluid side: a tank is a box without its lid.",
         {{"geometry", "word", "-", "required", "the shape, open or closed; or a shape here", ""},
          {"open", "words", "-", "()", "its faces that are no wall", ""},
          {"fluid", "word", "-", "automatic",
           "where the fluid is: inside the shape, outside (of an open one: on the side of its normal), or where it "
           "lies at "
           "the start",
           "one of: automatic inside outside"},
          group("wall", "geometry", "triangles"),
          moving("point")}},
        {file,
         "in space: refinements: each",
         "Finer mesh there; it grows by 0.2 per distance away from it. Nodes keep their size as they move, but with "
         "holdSizes; round a moving wall it moves along then.",
         {{"type", "word", "-", "required", "box, sphere, or surface: all that is near a shape",
           "one of: box sphere surface"},
          {"meshSize", "scalar", "m", "required", "wanted length of edges there", "> 0"},
          {"min", "point", "m", "required", "of a box: its lowest corner", ""},
          {"max", "point", "m", "required", "of a box: its highest corner", ""},
          {"centre", "point", "m", "required", "of a sphere; also: origin", ""},
          {"origin", "point", "m", "required", "of a sphere: its centre", ""},
          {"radius", "scalar", "m", "required", "of a sphere", "> 0"},
          {"geometry", "word", "-", "required", "of a surface: the shape", ""},
          distance("surface")}},
    };
}

}  // namespace pfem
