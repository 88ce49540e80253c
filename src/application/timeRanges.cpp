#include "application/timeRanges.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

#include "base/error.hpp"

namespace pfem {

namespace {

double bound(const std::string& text, double open, const std::string& item) {
    if (text.empty()) return open;
    const auto value = asNumber(text);
    if (!value) throw UserError("Invalid time range '" + item + "' (expected for example '0.05:0.1,0.2:')");
    return *value;
}

}  // namespace

bool TimeRange::contains(double value) const {
    const double tolerance = 1e-9 * std::max(1e-300, std::abs(value));  // names have few digits
    return value >= from - tolerance && value <= to + tolerance;
}

std::vector<TimeRange> parseTimeRanges(const std::string& text) {
    std::string blanks = text;
    for (char& c : blanks)
        if (c == ',' || c == ';') c = ' ';
    std::istringstream stream(blanks);
    std::vector<TimeRange> ranges;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::string item; stream >> item;) {
        if (item == "none") continue;
        const auto colon = item.find(':');
        if (colon == std::string::npos) {
            const double value = bound(item, 0, item);
            ranges.push_back({value, value});
            continue;
        }
        ranges.push_back(
            {bound(item.substr(0, colon), -infinity, item), bound(item.substr(colon + 1), infinity, item)});
    }
    return ranges;
}

std::vector<TimeFolder> selectTimes(const Case& theCase, const Options& options) {
    const TimeFolders all = listTimes(theCase.root());
    for (const auto& folder : all.ignored)
        std::cerr << "--> PFEM Warning : time folder " << folder.name << " is ignored: " << folder.reason << "\n";
    std::vector<TimeFolder> times = all.complete;
    if (options.found("time")) {
        const auto ranges = parseTimeRanges(options.get("time"));
        std::erase_if(times, [&](const TimeFolder& time) {
            return std::none_of(ranges.begin(), ranges.end(),
                                [&](const TimeRange& r) { return r.contains(time.value); });
        });
    }
    if (options.found("noZero")) std::erase_if(times, [](const TimeFolder& time) { return time.value == 0; });
    if (options.found("latestTime") && !times.empty()) times.erase(times.begin(), times.end() - 1);
    if (times.empty()) {
        const std::size_t n = all.complete.size();
        throw UserError("no times selected: the case \"" + theCase.root().string() + "\" has " + std::to_string(n) +
                        " complete time folders" +
                        (n > 0 ? ", from " + all.complete.front().name + " to " + all.complete.back().name : ""));
    }
    return times;
}

}  // namespace pfem
