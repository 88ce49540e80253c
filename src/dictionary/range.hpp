#pragma once
// What values an entry may have, with the text that documents it.

#include <limits>
#include <string>
#include <vector>

namespace pfem {

/// An interval for numbers (and for each component of vectors and lists) or a list of words.
struct Range {
    std::string text;  ///< "> 0", ">= 1", "one of: a b c"; "" if any value will do
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool lowerIncluded = true;
    bool upperIncluded = true;
    std::vector<std::string> words;

    bool holds(double x) const {
        return (lowerIncluded ? x >= lower : x > lower) && (upperIncluded ? x <= upper : x < upper);
    }
};

inline const Range any{};
inline const Range positive{.text = "> 0", .lower = 0, .lowerIncluded = false, .words = {}};
inline const Range nonNegative{.text = ">= 0", .lower = 0, .words = {}};

Range atLeast(double n);
Range atMost(double n);
Range between(double a, double b);  ///< both ends included
Range oneOf(std::vector<std::string> words);

}  // namespace pfem
