#pragma once
// Meshes of other programs as the initial mesh: Gmsh's .msh and VTK's .vtu.

#include <filesystem>

#include "mesh/foreignMesh.hpp"
#include "mesher/mesher.hpp"

namespace pfem {

/// By the file's ending. `cellArray`: the cells' array in a .vtu that numbers the groups.
/// Throws UserError with file and, for .msh, line.
template <int Dim = 2>
ForeignMeshOf<Dim> readMeshFile(const std::filesystem::path& file, const std::string& cellArray);

/// Gmsh's versions 2.2 and 4.1, text or binary: triangles and edges of the plane z = 0, or tetrahedra and triangles,
/// with what else a file may have (places on the geometry, parts, other sections). The groups are the physical groups;
/// one without a name is called by its number. What is in no group is in one of its entity: "surface 2", "curve 5".
template <int Dim = 2>
ForeignMeshOf<Dim> readMsh(const std::filesystem::path& file);

/// Does the file hold tetrahedra? No, where it cannot be read.
bool holdsTetrahedra(const std::filesystem::path& file);

/// As buildMesh, with the triangles of `file` instead of new ones: description's bodies, patches and walls are groups
/// of it, walls may be lines of points, too. Points at one place are joined. Nodes::h: mean length of the edges at the
/// node. Throws UserError: no such group, degenerate or overlapping triangles, bodies that touch without common nodes,
/// edges of a patch that are not on its body's outline, a wall with the fluid on its right.
MeshResult takeMesh(const MeshDescription& description, const ForeignMesh& file);

}  // namespace pfem
