#pragma once
// Contract of the dictionary reader (OpenFOAM's grammar).

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace pfem {

class Dictionary;

}  // namespace pfem
