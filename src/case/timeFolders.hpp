#pragma once
// The time folders of a case and how their names come about.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pfem {

/// A complete time folder. `value` is what the name says; the exact time is in uniform/time.
struct TimeFolder {
    std::string name;
    double value = 0;  // [s]
};

/// A folder with a number as name that no run can start from, and why.
struct IgnoredFolder {
    std::string name;
    std::string reason;
};

struct TimeFolders {
    std::vector<TimeFolder> complete;    // ascending
    std::vector<IgnoredFolder> ignored;  // ascending
};

/// The folders of `root` whose names are numbers.
TimeFolders listTimes(const std::filesystem::path& root);

/// Remove a time folder so that it is complete or absent, also for a program that is killed meanwhile.
void removeTime(const std::filesystem::path& root, const std::string& name, std::error_code& error);

/// The number that is all of `text`, or nothing.
std::optional<double> asNumber(const std::string& text);

/// "general", "fixed" or "scientific", as std::ostream prints: 0.05, 0.1, 1e-06.
std::string timeName(double value, const std::string& format = "general", int precision = 6);

/// The smallest precision from `precision` to 17 at which two times that follow each other have different names and the
/// name of b is nearer to it than 1/300 of their distance: so the names of times stay in their order.
int precisionToDistinguish(double a, double b, const std::string& format, int precision);

}  // namespace pfem
