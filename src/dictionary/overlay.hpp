#pragma once
// Files as they would be after changes that nobody has written.

#include <filesystem>
#include <map>
#include <string>

#include "dictionary/dictionary.hpp"

namespace pfem {

/// Texts that stand for files, by their canonical paths (std::filesystem::weakly_canonical).
using Overlay = std::map<std::filesystem::path, std::string>;

/// The dictionary in `file`: of the files in `changed`, also included ones, the texts count. Throws UserError.
Dictionary readWith(const Overlay& changed, const std::filesystem::path& file);

}  // namespace pfem
