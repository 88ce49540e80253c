#pragma once
// Surfaces of triangles in files: STL (text and binary), OBJ, OFF, VTP.

#include <filesystem>

#include "mesh/triSurface.hpp"

namespace pfem {

/// Points as they stand in the file (of an STL three to a triangle). Regions are the solids of an STL, the groups of an
/// OBJ, and the values of a VTP's cell array `region`; without any there is one, called as the file without its ending.
/// Polygons are cut into triangles. Throws UserError naming the file and the line.
TriSurface readSurfaceFile(const std::filesystem::path& file);

/// By the ending of its name; internal to src/io but for tests.
TriSurface readStl(const std::filesystem::path& file);
TriSurface readObj(const std::filesystem::path& file);
TriSurface readOff(const std::filesystem::path& file);
TriSurface readVtp(const std::filesystem::path& file);

}  // namespace pfem
