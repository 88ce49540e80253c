#pragma once
// The banner, FoamFile header and last line of the dictionaries that programs write.

#include <string>

namespace pfem {

/// Banner and FoamFile header of a dictionary called `object` in the folder `location`.
std::string dictionaryHeader(const std::string& object, const std::string& location);

/// "// ***...*** //" with a line end.
std::string dictionaryEndLine();

}  // namespace pfem
