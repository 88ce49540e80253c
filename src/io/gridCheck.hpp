#pragma once
// A look at a .vtu file before VTK reads it: VTK's reader trusts the counts in it, and dies of some that are wrong.

#include <functional>
#include <optional>
#include <string>

namespace pfem {

/// What is wrong, "" when nothing, and in which line of the file's head it is said. `foreign`: sound it may be, but
/// writeGrid does not write such words.
struct Damage {
    std::string reason;
    int line = 0;
    bool foreign = false;
};

/// Of a .vtu file that writeGrid is said to have made: another encoding, elements or types that it does not write, more
/// points, cells or tuples than the file can hold, blocks of data that are not within it or could not be decompressed
/// to what is promised, arrays of another size than their points, cells and components ask for. What concerns an array
/// names it.
Damage damageOf(const std::string& file);

/// The bytes of one compressed block (its bytes, their number, number of bytes that they stand for), nothing where it
/// is broken.
using Unpack = std::function<std::optional<std::string>(const char* bytes, std::size_t n, std::size_t whole)>;

/// The first array of a file without any such damage that has a block which cannot be unpacked, or another number of
/// strings than it says; "" without. `onlyStrings`: arrays of numbers are not unpacked.
std::string brokenArray(const std::string& file, const Unpack& unpack, bool onlyStrings);

}  // namespace pfem
