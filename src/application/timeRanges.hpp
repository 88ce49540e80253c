#pragma once
// Which time folders a utility works on: -time '0.05:0.1,0.2:', -latestTime, -noZero.

#include <string>
#include <vector>

#include "application/options.hpp"
#include "case/timeFolders.hpp"

namespace pfem {

/// One item of a list of ranges; an open end is infinite, a single value has both ends equal.
struct TimeRange {
    double from, to;
    bool contains(double value) const;
};

/// Items separated by commas or blanks: "a:b", "a:", ":b", ":", "a", "none". Throws UserError.
std::vector<TimeRange> parseTimeRanges(const std::string& text);

/// The complete time folders of the case that the options select, ascending; incomplete ones are named on
/// stderr. Throws UserError when none is left.
std::vector<TimeFolder> selectTimes(const Case& theCase, const Options& options);

}  // namespace pfem
