#include "reference/meshEntries.hpp"

namespace pfem {

// What mesher/readMeshDict.cpp reads; a test compares the names.
std::vector<KeywordTable> meshKeywords() {
    const std::string file = "system/meshDict";
    using namespace meshEntries;
    const EntryDescription size = meshEntries::size("triangles'"), arcs = meshEntries::arcs("");
    return {
        {file,
         "",
         "Bodies and walls, in metres. `pfemMesh -h` takes another meshSize; those of bodies, walls and refinements "
         "keep their ratio to it.",
         {{"meshSize", "scalar", "m", "required",
           "wanted length of the triangles' edges, where bodies and walls have none of their own", "> 0"},
          {"dimension", "int", "-", "3 with geometry, else 2", "2: polygons, triangles; 3: shapes in space, tetrahedra",
           "2 or 3"},
          {"geometry", "dictionaries", "-", "optional", "in space: shapes by name", ""},
          {"bodies", "dictionaries", "-", "required", "the bodies by name", ""},
          {"walls", "dictionaries", "-", "optional", "the rigid walls by name", ""},
          {"refinements", "dictionaries", "-", "optional", "places of finer mesh by name", ""},
          {"holdSizes", "bool", "-", "no",
           "sizes belong to places: water that flows into a refinement, to a solid or a wall of finer mesh gets their "
           "size, and its own again behind",
           ""},
          {"meshFile", "file", "-", "optional",
           "take the triangles or tetrahedra of this file, relative to the case, instead of making them: Gmsh's .msh "
           "(2.2 or 4.1, "
           "text or binary) or .vtu",
           ""},
          {"scale", "scalar", "-", "1", "from the lengths of meshFile to metres", "> 0"},
          {"cellArray", "word", "-", "material", "of a .vtu: the cells' integer array that numbers the groups", ""}}},
        {file, "bodies: each", "Bodies that touch share their nodes.",
         joined(
             bodyRows(),
             {{"vertices", "list of points", "m", "required",
               "corners (x y), counter-clockwise, numbered from 0; those within 1e-6 meshSize are one, and of those "
               "finer "
               "than half of it only what shows at that size is kept (within 0.05 of it)",
               ""},
              arcs,
              {"level", "scalar", "m", "none",
               "still water: the body is filled up to this height y; what of its outline is above is cut off", ""},
              size,
              velocity("(0 0)", "\"-2*y\" \"2*x\""),
              {"pattern", "word", "-", "unstructured", "regular meshes are for bodies with four vertices",
               "one of: unstructured checkerboard oneWay crossed"},
              {"cells", "list of int", "-", "from meshSize", "of a pattern: cells along the edges 0-1 and 1-2", ">= 1"},
              {"holes", "list of word", "-", "()",
               "bodies whose outlines are cut out of this one; they may touch its outline and each other", ""},
              group("body", "vertices", "triangles; \"surface 2\": an entity in no physical group"),
              patches("outline")})},
        {file,
         "bodies: patches: each",
         "A part of the body's outline.",
         {{"edges", "list of pairs", "-", "required",
           "edges by their two vertices, ((3 0)); of an outline of two vertices in their order", ""},
          group("patch", "edges", "edges")}},
        {file,
         "refinements: each",
         "Finer unstructured mesh there; it grows by 0.2 per distance away from it. Nodes keep their size as they "
         "move, but with holdSizes.",
         {{"type", "word", "-", "required", "box, sphere, or curve: all that is near a line",
           "one of: box sphere curve"},
          {"meshSize", "scalar", "m", "required",
           "wanted length of edges there; coarser than the body's own: no effect", "> 0"},
          {"min", "point", "m", "required", "of a box: lower left corner", ""},
          {"max", "point", "m", "required", "of a box: upper right corner", ""},
          {"centre", "point", "m", "required", "of a sphere; also: origin", ""},
          {"origin", "point", "m", "required", "of a sphere: its centre", ""},
          {"radius", "scalar", "m", "required", "of a sphere, in the plane a circle", "> 0"},
          {"points", "list of points", "m", "required", "of a curve: its corners (x y)", ""},
          distance("curve")}},
        {file,
         "walls: each",
         "A line with the fluid on its left.",
         {{"points", "list of points", "m", "required", "corners (x y)", ""},
          arcs,
          size,
          group("wall", "points", "edges"),
          {"closed", "bool", "-", "no", "join the last point to the first", ""},
          moving("corner")}},
    };
}

}  // namespace pfem
