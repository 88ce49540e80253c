#pragma once
// Surfaces with fields for ParaView: .vtp files, a time each, and the .vtp.series file that lists them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// An array of a surface: `components` numbers for each point.
struct SurfaceField {
    std::string name;
    int components = 1;  // 1, 3 or 6 (xx yy zz xy yz xz)
    std::vector<double> values;
};

/// Points in space, cells of them (2: a line, 3 or more: a polygon), and what is known of both.
struct FieldSurface {
    Points<3> x;
    std::vector<std::vector<int>> cells;
    std::vector<int> material;  // of each cell
    std::vector<std::string> materials;
    std::vector<SurfaceField> fields;
};

/// The .vtp file: complete or absent; the same surface gives the same bytes. Throws UserError.
void writeSurface(const std::filesystem::path& file, const FieldSurface& surface, double time);

/// The list <folder>/<name>.vtp.series of the files <folder>/<time>/<name>.vtp.
class SurfaceSeries {
public:
    /// With `resumeAt` [s] the files up to that time are in the list, otherwise it begins empty.
    SurfaceSeries(std::filesystem::path folder, std::string name, std::optional<double> resumeAt);

    /// Write the file of a time and the list with it. Throws UserError.
    void add(const FieldSurface& surface, double time);

private:
    std::filesystem::path folder_;
    std::string name_;
    std::vector<std::pair<double, std::string>> times_;  // ascending, with the folders' names
};

}  // namespace pfem
