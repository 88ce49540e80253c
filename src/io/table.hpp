#pragma once
// Text tables of postProcessing/: OpenFOAM's columns, each row on the disk as soon as it is written.

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pfem {

/// Lines of a file that is begun anew. Throws UserError when it cannot be written.
class Table {
public:
    Table(const std::filesystem::path& file, int precision);

    /// "# text"
    void comment(const std::string& text);

    /// '#' and one title per column, right-aligned.
    void header(const std::vector<std::string>& titles);

    /// Right-aligned columns of width precision + 7; what is a scalar or already text ("(1 2 3)").
    void row(const std::vector<std::string>& columns);

    /// A number at the table's precision.
    std::string number(double value) const;
    /// "(1 2 3)", padded as OpenFOAM pads: the width counts for the opening bracket only.
    std::string tuple(const std::vector<double>& values) const;

    int width() const { return precision_ + 7; }

    /// Text as it is.
    void line(const std::string& text);

private:
    std::filesystem::path file_;
    std::ofstream stream_;
    int precision_;
};

}  // namespace pfem
