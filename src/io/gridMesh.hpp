#pragma once
// A .vtu file of any origin as a mesh to begin with.

#include <filesystem>

#include "mesh/foreignMesh.hpp"

namespace pfem {

/// Its triangles and lines (polylines) of the plane z = 0, or its tetrahedra and triangles; other cells but vertices
/// (and lines in space) are errors. The groups are the
/// values of the cells' integer array `cellArray`; where the file has an array of words called `cellArray`s, as the
/// files of time folders have `materials`, its words, else the numbers. Without the array all are in group "0". Throws
/// UserError naming the file.
template <int Dim>
ForeignMeshOf<Dim> readGridMesh(const std::filesystem::path& file, const std::string& cellArray);

}  // namespace pfem
