#include "mesher/meshFile.hpp"

#include "base/error.hpp"
#include "io/gridMesh.hpp"

namespace pfem {

ForeignMesh readMeshFile(const std::filesystem::path& file, const std::string& cellArray) {
    const auto ending = file.extension().string();
    if (!std::filesystem::is_regular_file(file))
        throw UserError("cannot find file \"" + file.string() + "\"", {file.string(), 0});
    if (ending == ".msh") return readMsh(file);
    if (ending == ".vtu") return readGridMesh(file, cellArray);
    throw UserError(notValid(ending, "ending of a mesh file", {".msh", ".vtu"}), {file.string(), 0});
}

}  // namespace pfem
