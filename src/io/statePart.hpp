#pragma once
// One .vtu file of a time folder, read and checked. Internal to src/io.

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/uniformTime.hpp"

namespace pfem {

/// One file, checked: its nodes, and per cell the type, the ids of its nodes and its integer.
template <int Dim>
struct Part {
    std::string file;
    Nodes<Dim> nodes;
    bool hasStress = false;
    std::vector<int> types;
    std::vector<std::vector<Id>> cells;
    std::vector<Id> values;
    std::vector<Stress<Dim>> cellStress;  // empty without cell data `sigma`
    History cellHistory;                  // empty without cell data of the names in field data `history`
    std::vector<std::string> materials;
    std::vector<std::string> patchNames;  // boundary.vtu only

    [[noreturn]] void fail(const std::string& reason) const {
        throw UserError("cannot read \"" + file + "\": " + reason, {file, 0});
    }
};

/// Read file `name` of the folder; `values`: its integer cell array. Throws UserError naming the file when it
/// is missing, damaged, or holds anything but finite numbers, ascending ids and cells of existing points.
template <int Dim>
Part<Dim> readPart(const std::filesystem::path& folder, const std::string& name, const std::string& values,
                   const UniformTime& uniform);

}  // namespace pfem
