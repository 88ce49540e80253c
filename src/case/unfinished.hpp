#pragma once
// What a run has left that was killed while it wrote a time folder.

#include <filesystem>
#include <string>
#include <vector>

namespace pfem {

/// Remove the unfinished folders (.<time>.tmp) of a case, and put back a finished one that was just being replaced.
/// Only the holder of the case's lock may do so. Returns what was done, one sentence for each.
std::vector<std::string> clearUnfinished(const std::filesystem::path& root);

}  // namespace pfem
