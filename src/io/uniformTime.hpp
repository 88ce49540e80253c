#pragma once
// <time>/uniform/time: the numbers of a state that belong to no node, as a dictionary.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "state/state.hpp"

namespace pfem {

/// The content of uniform/time.
struct UniformTime {
    TimeInfo time;
    Id nextId = 0;
    double approach = 0;                           // of surfaces that are about to meet or have just met [1/s]
    std::map<std::string, double> ledger;          // cumulative fluid volume by cause [m2 (2D), m3]
    std::map<std::string, double> energy = {};     // the same for energy [J/m (2D), J]
    std::map<std::string, std::string> checksums;  // of the folder's files, by checksumOf(); or "none"
    std::map<std::string, std::vector<double>> memory = {};  // of function objects
    std::string name = {};                                   // of the folder, as it was written; only read
};

/// The text of the file in the folder named `folderName`; numbers in the shortest form that reads back to
/// the same bits. Throws InternalError when a number is not finite or a cause is not a plain word.
std::string formatUniformTime(const UniformTime& uniform, const std::string& folderName);

/// Read `folder`/uniform/time. Throws UserError naming the file when it is missing or makes no sense.
UniformTime readUniformTime(const std::filesystem::path& folder);

/// Size and 64-bit FNV-1a hash of a file's bytes: tells a damaged file before anybody trusts it.
std::string checksumOf(const std::string& bytes);

}  // namespace pfem
