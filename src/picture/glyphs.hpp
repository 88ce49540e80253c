#pragma once
// The strokes of the characters. Internal to src/picture.

#include <map>

namespace pfem {

/// Strokes separated by blanks. A point is a digit (x) and a letter (y: a = -3, d = 0 the baseline, j = 6,
/// m = 9 the capitals' height). First character of a stroke: - straight, ~ smooth, o smooth and closed.
const std::map<char, const char*>& glyphs();

}  // namespace pfem
