#pragma once
// A look at a .vtu file before VTK reads it: VTK's reader trusts the counts in it, and dies of some that are wrong.

#include <string>

namespace pfem {

/// What is wrong with a .vtu file that writeGrid is said to have made, or "": another encoding, elements or types that
/// it does not write, more points, cells or tuples than the file can hold, blocks of data that are not within it or could
/// not be decompressed to what is promised.
std::string damageOf(const std::string& file);

}  // namespace pfem
