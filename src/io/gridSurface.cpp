#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPolyData.h>

#include <cmath>

#include "base/error.hpp"
#include "io/gridFile.hpp"
#include "io/surfaceFile.hpp"

namespace pfem {

TriSurface readVtp(const std::filesystem::path& file) {
    const auto data = readPolyData(file);
    const auto fail = [&](const std::string& message) {
        throw UserError("cannot read the surface \"" + file.string() + "\": " + message, {file.string(), 0});
    };
    TriSurface surface;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        double x[3];
        data->GetPoint(i, x);
        for (const double c : x)
            if (!std::isfinite(c)) fail(fmt::format("point {} is not finite", i));
        surface.x.push_back({x[0], x[1], x[2]});
    }
    vtkCellArray* polygons = data->GetPolys();
    if (polygons == nullptr || !polygons->IsValid()) fail("its polygons are damaged");
    vtkDataArray* values = data->GetCellData()->GetArray("region");
    const vtkIdType before = data->GetNumberOfVerts() + data->GetNumberOfLines();  // cell data begin with those
    if (values != nullptr && values->GetNumberOfTuples() != data->GetNumberOfCells())
        fail("array 'region' is not one number per cell");
    for (vtkIdType e = 0; e < polygons->GetNumberOfCells(); ++e) {
        vtkIdType n = 0;
        const vtkIdType* corners = nullptr;
        polygons->GetCellAtId(e, n, corners);
        for (vtkIdType k = 0; k < n; ++k)
            if (corners[k] < 0 || corners[k] >= data->GetNumberOfPoints())
                fail(fmt::format("polygon {} refers to point {} of {}", e, corners[k], data->GetNumberOfPoints()));
        const std::string name =
            values != nullptr ? fmt::format("region{}", values->GetTuple1(before + e)) : file.stem().string();
        int region = surface.regionNamed(name);
        if (region < 0) region = static_cast<int>(surface.regions.size()), surface.regions.push_back(name);
        for (vtkIdType k = 1; k + 1 < n; ++k) {
            surface.triangles.push_back(
                {static_cast<int>(corners[0]), static_cast<int>(corners[k]), static_cast<int>(corners[k + 1])});
            surface.region.push_back(region);
        }
    }
    return surface;
}

}  // namespace pfem
