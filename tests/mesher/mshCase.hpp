#pragma once
// The dam break as a state, and the same state out of a .msh file.

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "cases.hpp"
#include "mesher/meshFile.hpp"
#include "mshWriter.hpp"

namespace pfem::testing {

struct Folder {
    Folder() : path(std::filesystem::temp_directory_path() / ("pfemMeshFile" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name, std::ios::binary) << text;
        return path / name;
    }
    std::filesystem::path path;
};

inline MeshDescription fileDict(const std::string& bodies, const std::string& walls, const std::string& more = "") {
    return describe("meshFile \"x.msh\"; " + more + " bodies { " + bodies + " } walls { " + walls + " }");
}

inline const std::string fileBodies =
    "water { type fluid; material water; } "
    "beam { type solid; material rubber; group wall; patches { wallBase { } } }";
inline const std::string fileTank = "tank { points ((0 0.6) (0 0) (0.596 0) (0.596 0.6)); }";

inline void expectSame(const State<2>& a, const State<2>& b) {
    expectSound(b);
    EXPECT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_EQ(a.mesh.fluid.size(), b.mesh.fluid.size());
    EXPECT_EQ(a.mesh.solid.size(), b.mesh.solid.size());
    EXPECT_EQ(a.mesh.materials, b.mesh.materials);
    for (const auto& patch : a.mesh.patches) {
        EXPECT_EQ(patch.faces.size(), patchOf(b, patch.name).faces.size()) << patch.name;
        EXPECT_NEAR(lengthOf(a, patch.name), lengthOf(b, patch.name), 1e-9) << patch.name;
    }
    const auto sliding = [](const State<2>& s) {
        return std::count_if(s.nodes.wall.begin(), s.nodes.wall.end(), [](const auto& w) { return isSupported(w); });
    };
    EXPECT_EQ(sliding(a), sliding(b));
}

struct MshCase {
    Folder folder;
    State<2> state = meshOf(damBreakElasticWall(), 0.02).state;

    MeshDescription description() const { return fileDict(fileBodies, fileTank); }
    std::filesystem::path write(const MshForm& form) const { return folder.write("x.msh", mshText(state, form)); }
};

inline void expectReadAgain(const MshForm& form) {
    const MshCase c;
    try {
        expectSame(c.state, takeMesh(c.description(), readMsh(c.write(form))).state);
    } catch (const UserError& error) {
        ADD_FAILURE() << error.what();
    }
}

/// What is said of a file that is not taken.
inline std::string refusal(const MshForm& form) {
    const MshCase c;
    try {
        takeMesh(c.description(), readMsh(c.write(form)));
    } catch (const UserError& error) {
        return error.what();
    }
    ADD_FAILURE() << "it was taken";
    return "";
}

}  // namespace pfem::testing
