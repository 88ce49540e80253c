#pragma once
// Tables of postProcessing/<function>/<startTime>/ that a restarted run goes on with.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pfem {

/// The lines of a table: leading comments, and rows whose first column is a time.
struct TableText {
    std::vector<std::string> head;
    std::vector<std::string> rows;
};

/// The table that one of a run from <startTime> continues: the same file name in the sibling folder with the largest
/// number below <startTime>; nothing without one.
std::optional<std::filesystem::path> previousTable(const std::filesystem::path& file);

/// Rows up to `time` [s]; a last line that was cut off when a run was killed is left out. Throws UserError.
TableText readTable(const std::filesystem::path& file, double time);

/// A time as tables print it: twelve digits, so that no two steps of a run look alike, or with a larger precision all
/// 17: then the text means exactly that time, and a restart finds the row.
std::string timeText(double time, int precision = 0);

}  // namespace pfem
