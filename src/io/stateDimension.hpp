#pragma once
// Is a time folder of the plane or of space?

#include <filesystem>

namespace pfem {

/// 3 when a file of the folder holds tetrahedra, else 2. Throws UserError when none can be read.
int stateDimension(const std::filesystem::path& folder);

}  // namespace pfem
