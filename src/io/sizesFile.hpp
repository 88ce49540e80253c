#pragma once
// <time>/uniform/sizes: mesh sizes that belong to places, as a dictionary; only where a state has some.

#include <filesystem>
#include <string>

#include "state/placeSizes.hpp"

namespace pfem {

/// The text of the file in the folder named `folderName`; numbers in the shortest form that reads back to the same
/// bits.
template <int Dim>
std::string formatSizes(const PlaceSizes<Dim>& sizes, const std::string& folderName);

/// Read `folder`/uniform/sizes, which must have this checksum (`none`: any). Throws UserError naming the file.
template <int Dim>
PlaceSizes<Dim> readSizes(const std::filesystem::path& folder, const std::string& checksum);

}  // namespace pfem
