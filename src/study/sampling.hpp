#pragma once
// The table of a study: the parameters' values in each case.

#include <string>
#include <vector>

#include "study/sweep.hpp"

namespace pfem {

/// A row per case, a column per parameter; values as they are written in a dictionary. Throws UserError.
///   grid            all combinations, the last parameter changing fastest
///   list            the k-th values of all parameters
///   latinHypercube  McKay, Beckman, Conover (1979): each parameter has one sample in each of `samples` equally wide
///                   parts of its range (of its logarithm with scale log), the parts in random order. Values in place
///                   of a range are taken equally often, as far as that goes. The same seed gives the same table
///                   everywhere.
std::vector<std::vector<std::string>> sampleCases(const Sweep& sweep);

}  // namespace pfem
