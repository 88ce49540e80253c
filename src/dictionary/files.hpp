#pragma once
// Files named in dictionaries: reading them and finding them in the etc folders.

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"

namespace pfem {

/// Length of the byte order mark that some editors put at the beginning of a text; 0: there is none.
std::size_t byteOrderMark(const std::string& text);

/// The whole file without its byte order mark; UserError at `where` (or naming the file itself) if it is missing, a
/// folder or unreadable.
std::string fileText(const std::filesystem::path& file, const Location& where);

/// In $PFEM_ETC, ~/.pfem, the etc folder of the installation; the first that has the file.
std::optional<std::filesystem::path> findEtc(const std::filesystem::path& name);

/// A function object's file below caseDicts/postProcessing of those folders.
std::optional<std::filesystem::path> findFunction(const std::string& name);

/// <etc>, <case>, <constant>, <system> at the start, and ~ . The case is $PFEM_CASE, $FOAM_CASE, the folder
/// above `file` that has system/controlDict, or the current folder.
std::filesystem::path expandTags(const std::string& name, const std::filesystem::path& file);

}  // namespace pfem
