#include "io/surfaceSeries.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "io/gridArrays.hpp"
#include "io/gridFile.hpp"
#include "io/stateGrid.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

vtkSmartPointer<vtkPolyData> polyData(const FieldSurface& surface, double time) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    const int n = static_cast<int>(surface.x.size());
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetData(makeArray<vtkDoubleArray>("Points", 3, n, [&](int i, int c) { return surface.x[i][c]; }));
    data->SetPoints(points);
    auto lines = vtkSmartPointer<vtkCellArray>::New(), polygons = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& cell : surface.cells) {  // lines alone or polygons alone: the order of the cells stays
        auto& cells = cell.size() == 2 ? lines : polygons;
        cells->InsertNextCell(static_cast<int>(cell.size()));
        for (const int i : cell) cells->InsertCellPoint(i);
    }
    data->SetLines(lines);
    data->SetPolys(polygons);
    for (const auto& field : surface.fields) {
        auto array = makeArray<vtkDoubleArray>(field.name, field.components, n, [&](int i, int c) {
            return field.values[static_cast<std::size_t>(i) * field.components + c];
        });
        for (int c = 0; c < 6 && field.components == 6; ++c)
            array->SetComponentName(c, stateGrid::tensorComponents[static_cast<std::size_t>(c)]);
        data->GetPointData()->AddArray(array);
    }
    data->GetCellData()->AddArray(makeArray<vtkIntArray>("material", 1, static_cast<int>(surface.cells.size()),
                                                         [&](int i, int) { return surface.material[i]; }));
    data->GetFieldData()->AddArray(makeArray<vtkDoubleArray>("TimeValue", 1, 1, [&](int, int) { return time; }));
    data->GetFieldData()->AddArray(makeWords("materials", surface.materials));
    return data;
}

void makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw UserError("cannot make the folder \"" + folder.string() + "\": " + error.message());
}

}  // namespace

void writeSurface(const fs::path& file, const FieldSurface& surface, double time) {
    static std::mutex vtkErrors;  // are collected for the whole program; functions of a run work at the same time
    const std::lock_guard lock(vtkErrors);
    const fs::path beside = file.parent_path() / ("." + file.filename().string() + ".tmp");
    writePolyData(beside, polyData(surface, time));
    flushToDisk(beside);
    std::error_code error;
    fs::rename(beside, file, error);
    if (error) throw UserError("cannot write \"" + file.string() + "\": " + error.message());
}

SurfaceSeries::SurfaceSeries(fs::path folder, std::string name, std::optional<double> resumeAt)
    : folder_(std::move(folder)), name_(std::move(name)) {
    std::error_code none;
    if (!resumeAt || !fs::is_directory(folder_, none)) return;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        const std::string time = entry.path().filename().string();
        const auto value = asNumber(time);
        if (value && *value <= *resumeAt + 1e-9 * std::abs(*resumeAt) && fs::exists(entry.path() / (name_ + ".vtp")))
            times_.emplace_back(*value, time);
    }
    std::sort(times_.begin(), times_.end());
}

void SurfaceSeries::add(const FieldSurface& surface, double time) {
    const std::string folder = timeName(time, "general", 12);
    makeFolder(folder_ / folder);
    writeSurface(folder_ / folder / (name_ + ".vtp"), surface, time);
    if (times_.empty() || times_.back().second != folder) times_.emplace_back(time, folder);
    std::string text = "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
    for (const auto& [value, name] : times_)
        text += fmt::format("{}    {{ \"name\" : \"{}/{}.vtp\", \"time\" : {} }}",
                            &name == &times_.front().second ? "\n" : ",\n", name, name_, name);
    writeAtomically(folder_ / (name_ + ".vtp.series"), text + "\n  ]\n}\n");
}

}  // namespace pfem
