#pragma once
// Reading the tables of postProcessing/<function>/<startTime>/: for runs that go on with them, and as numbers.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace pfem {

/// The lines of a table: leading comments, and rows whose first column is a time.
struct TableText {
    std::vector<std::string> head;
    std::vector<std::string> rows;
    std::vector<int> lineNumber;  // of each row in the file

    /// The words of the last comment.
    std::vector<std::string> titles() const;

    /// Does each column belong to a probe ("# Probe 0 (x y z)")?
    bool ofProbes() const;
};

/// The table that one of a run from <startTime> continues: the same file name in the sibling folder with the largest
/// number below <startTime>; nothing without one.
std::optional<std::filesystem::path> previousTable(const std::filesystem::path& file);

/// A last row that is cut off, because a run writes it or was killed, is left out. Throws UserError.
TableText readTable(const std::filesystem::path& file);

/// The rows up to `time` [s], at most to the first one that does not begin with a time.
TableText upTo(double time, TableText table);

/// The words of a line.
std::vector<std::string> wordsOf(const std::string& line);

/// The numbers of a row by columns: those in brackets, components of a vector, are one column. Throws UserError with
/// `where` for what is not a number.
std::vector<std::vector<double>> numbersOf(const std::string& row, const Location& where);

/// A time as tables print it: twelve digits, so that no two steps of a run look alike, or with a larger precision all
/// 17: then the text means exactly that time, and a restart finds the row.
std::string timeText(double time, int precision = 0);

}  // namespace pfem
