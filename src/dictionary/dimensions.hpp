#pragma once
// Dimension sets: [0 1 -2 0 0 0 0] or [m s^-2] or [m/s^2].

#include <array>
#include <string>

#include "dictionary/tokenReader.hpp"

namespace pfem {

using Dimensions = std::array<double, 7>;  ///< exponents of kg m s K mol A cd

/// Reads from '[' to ']'. 5 or 7 numbers, or SI symbols with ^ * / . and parentheses.
Dimensions readDimensions(TokenReader& tokens);

bool sameDimensions(const Dimensions& a, const Dimensions& b);

/// "[1 -1 -2 0 0 0 0] (kg m^-1 s^-2)"
std::string toString(const Dimensions& dimensions);

}  // namespace pfem
