#pragma once
// A time folder: fluid.vtu, solid.vtu, boundary.vtu and uniform/time hold one State at full precision.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "state/state.hpp"

namespace pfem {

/// Nodal arrays for the eye only (freeSurface, solid pressure, ...): written, never read back.
struct ExtraFields {
    std::map<std::string, std::vector<double>> nodal;  // one value per node of the state
    std::map<std::string, std::vector<unsigned char>> nodalFlags;
    std::map<std::string, std::vector<double>> ofFluid;  // as nodal, but in fluid.vtu alone
};

/// Write all files of `state` into `folder`: complete or absent (written beside it, then renamed).
/// Throws UserError when the disk is full or the folder cannot be written.
template <int Dim>
void writeState(const std::filesystem::path& folder, const State<Dim>& state, const ExtraFields& extra = {});

/// Read back, byte for byte what was written. Throws UserError naming the file that is missing or corrupt.
template <int Dim>
State<Dim> readState(const std::filesystem::path& folder);

}  // namespace pfem
