#pragma once
// Gmsh's binary .msh, versions 2.2 and 4.1, as the text that Gmsh would have written: one reader then serves
// both.

#include <string>

namespace pfem {

/// Whether the header of a file with this content says that numbers are binary.
bool isBinaryMsh(const std::string& content);

/// The text form of a file with this content, which isBinaryMsh; sections that no mesh needs are empty in it.
/// Throws UserError, naming `name`: another order of bytes, another version, counts that the file does not
/// keep.
std::string textOfBinaryMsh(const std::string& content, const std::string& name);

}  // namespace pfem
