#include "mesher/meshFile.hpp"

#include "base/error.hpp"
#include "io/gridMesh.hpp"

namespace pfem {

template <int Dim>
ForeignMeshOf<Dim> readMeshFile(const std::filesystem::path& file, const std::string& cellArray) {
    const auto ending = file.extension().string();
    if (!std::filesystem::is_regular_file(file))
        throw UserError("cannot find file \"" + file.string() + "\"", {file.string(), 0});
    if (ending == ".msh") return readMsh<Dim>(file);
    if (ending == ".vtu") return readGridMesh<Dim>(file, cellArray);
    throw UserError(notValid(ending, "ending of a mesh file", {".msh", ".vtu"}), {file.string(), 0});
}

template ForeignMeshOf<2> readMeshFile<2>(const std::filesystem::path&, const std::string&);
template ForeignMeshOf<3> readMeshFile<3>(const std::filesystem::path&, const std::string&);

bool holdsTetrahedra(const std::filesystem::path& file) {
    try {
        return !readMeshFile<3>(file, "material").cells.empty();
    } catch (const UserError&) {
        return false;
    }
}

}  // namespace pfem
