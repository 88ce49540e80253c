#pragma once
// Text tables of postProcessing/: OpenFOAM's columns, each row on the disk as soon as it is written.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pfem {

/// Lines of a file. Throws UserError when it cannot be written.
///
/// Without `resumeAt` the file is begun anew. With the time [s] at which a run goes on, the table of the run before is
/// continued when its columns are the same: its rows up to that time stay, later ones (of a run that was killed) go,
/// so that the file becomes that of a run that was never stopped. Otherwise `file` is begun. Which one it is shows at
/// the first row.
///
/// A file that somebody removes or replaces meanwhile is begun again, or continued, under its name: rows never go into
/// a file that nobody can see.
class Table {
public:
    Table(const std::filesystem::path& file, int precision, std::optional<double> resumeAt = {});

    /// "# text"
    void comment(const std::string& text);

    /// '#' and one title per column, right-aligned.
    void header(const std::vector<std::string>& titles);

    /// Right-aligned columns of width precision + 7; what is a scalar or already text ("(1 2 3)").
    void row(const std::vector<std::string>& columns);

    /// All rows at once in place of those that are there; the file changes in one instant.
    void replaceRows(const std::vector<std::vector<std::string>>& rows);

    /// A number at the table's precision; a time with more digits.
    std::string number(double value) const;
    std::string time(double value) const;
    /// "(1 2 3)", padded as OpenFOAM pads: the width counts for the opening bracket only.
    std::string tuple(const std::vector<double>& values) const;

    int width() const { return precision_ + 7; }

    /// Text as it is.
    void line(const std::string& text);

private:
    void begin();
    void open(std::ios::openmode mode);
    void makeFolder() const;
    void followName();
    std::string rowText(const std::vector<std::string>& columns) const;

    std::filesystem::path file_;
    std::ofstream stream_;
    std::pair<std::uint64_t, std::uint64_t> identity_{};  // device and number of the open file
    int precision_;
    std::optional<double> resumeAt_;  // until the first row
    std::vector<std::string> head_;   // the comments before the first row
};

}  // namespace pfem
