#include "picture/glyphs.hpp"

namespace pfem {

// clang-format off
const std::map<char, const char*>& glyphs() {
    static const std::map<char, const char*> all{
        {'0', "o0d5d5m0m"}, {'1', "-0k2m2d"}, {'2', "~0k0m5m5h1e0d -0d5d"},
        {'3', "~0l1m5m5i2i ~2i5i5d0d0f"}, {'4', "-4d4m0g5g"}, {'5', "-5m1m0i ~0i1j5k5d1d0e"},
        {'6', "o0d5d5j0j ~5m2m0j0g"}, {'7', "-0m5m2d"}, {'8', "o0i5i5m0m o0d5d5i0i"},
        {'9', "o0g5g5m0m ~5j5g3d0d"}, {'.', "-1d1d"}, {',', "-1d0b"}, {':', "-1d1d -1i1i"}, {'-', "-0h4h"},
        {'+', "-0h4h -2f2j"}, {'=', "-0g4g -0i4i"}, {'/', "-0c4n"}, {'|', "-1n1b"}, {'_', "-0b5b"},
        {'(', "~2n0k0d2a"}, {')', "~0n2k2d0a"}, {'[', "-2n0n0b2b"}, {']', "-0n2n2b0b"},
        {'%', "-0d5m o0j2j2m0m o3d5d5g3g"}, {'*', "-2g2k -0h4j -0j4h"}, {'\'', "-1m1k"}, {'^', "-0j2m4j"},
        {'A', "-0d3m6d -1g5g"}, {'B', "-3m0m0d3d -0i3i ~3m6m6i3i ~3i6i6d3d"}, {'C', "~6k6m0m0d6d6f"},
        {'D', "-2m0m0d2d ~2m6m6d2d"}, {'E', "-5m0m0d5d -0i4i"}, {'F', "-0d0m5m -0i4i"},
        {'G', "~6k6m0m0d6d6h -6h3h"}, {'H', "-0d0m -6d6m -0i6i"}, {'I', "-1d1m"}, {'J', "-5m5g ~5g5d0d0g"},
        {'K', "-0d0m -6m0h -2i6d"}, {'L', "-0m0d5d"}, {'M', "-0d0m3f6m6d"}, {'N', "-0d0m6d6m"},
        {'O', "o0d6d6m0m"}, {'P', "-3m0m0d -0h3h ~3m6m6h3h"}, {'Q', "o0d6d6m0m -4f6c"},
        {'R', "-3m0m0d -0h3h ~3m6m6h3h -3h6d"}, {'S', "~6l5m0m0i6h6d1d0e"}, {'T', "-0m6m -3m3d"},
        {'U', "~0m0g0d6d6g6m"}, {'V', "-0m3d6m"}, {'W', "-0m2d4m6d8m"}, {'X', "-0d6m -0m6d"},
        {'Y', "-0m3h6m -3h3d"}, {'Z', "-0m6m0d6d"}, {'a', "o0d5d5j0j -5j5d"}, {'b', "-0m0d o0d5d5j0j"},
        {'c', "~5i5j0j0d5d5e"}, {'d', "o0d5d5j0j -5m5d"}, {'e', "-0g5g ~5g5j0j0d4d5e"},
        {'f', "-1d1k ~1k1m4m -0j3j"}, {'g', "o0d5d5j0j -5j5d ~5d5a1a0b"}, {'h', "-0m0d ~0g0j5j5g -5g5d"},
        {'i', "-1j1d -1l1l"}, {'j', "-1j1c ~1c1a0a -1l1l"}, {'k', "-0m0d -4j0f -2g5d"}, {'l', "-1m1d"},
        {'m', "-0j0d ~0g0j4j4g -4g4d ~4g4j8j8g -8g8d"}, {'n', "-0j0d ~0g0j5j5g -5g5d"}, {'o', "o0d5d5j0j"},
        {'p', "-0j0a o0d5d5j0j"}, {'q', "-5j5a o0d5d5j0j"}, {'r', "-0j0d ~0g0j3j"},
        {'s', "~5i4j0j0g5g5d1d0e"}, {'t', "-1l1f ~1f1d3d -0j3j"}, {'u', "-0j0g ~0g0d5d5g -5j5d"},
        {'v', "-0j2d4j"}, {'w', "-0j2d4j6d8j"}, {'x', "-0d5j -0j5d"}, {'y', "-0j3d -6j2b1a0a"},
        {'z', "-0j5j0d5d"}, {' ', ""},
    };
    return all;
}
// clang-format on

}  // namespace pfem
