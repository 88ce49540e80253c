#include "io/gridMesh.hpp"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkStringArray.h>

#include <cmath>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/gridCheck.hpp"
#include "io/gridFile.hpp"

namespace pfem {

namespace {

template <int Dim>
class GridMeshReader {
public:
    GridMeshReader(const std::filesystem::path& file, const std::string& cellArray) : grid_(readGrid(file)) {
        mesh_.file = file.string();
        auto* values = grid_->GetCellData()->GetAbstractArray(cellArray.c_str());
        values_ = vtkDataArray::SafeDownCast(values);
        if (values != nullptr && (values_ == nullptr || values_->GetNumberOfComponents() != 1 ||
                                  values_->GetNumberOfTuples() != grid_->GetNumberOfCells()))
            fail("the cells' array '" + cellArray + "' is not one number per cell");
        words_ = vtkStringArray::SafeDownCast(grid_->GetFieldData()->GetAbstractArray((cellArray + "s").c_str()));
    }

    ForeignMeshOf<Dim> read() {
        double x[3];
        for (vtkIdType i = 0; i < grid_->GetNumberOfPoints(); ++i) {
            grid_->GetPoint(i, x);
            if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || (Dim == 3 && !std::isfinite(x[2])))
                fail(fmt::format("point {} is not finite", i));
            if (Dim == 2 && std::abs(x[2]) > 1e-6 * grid_->GetLength())
                fail(fmt::format("point {} leaves the plane z = 0", i));
            mesh_.x.push_back(Eigen::Map<const Vec<Dim>>(x));
        }
        for (vtkIdType e = 0; e < grid_->GetNumberOfCells(); ++e) addCell(e);
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw UserError("cannot take the mesh of \"" + mesh_.file + "\": " + reason, {mesh_.file, 0});
    }

    void addCell(vtkIdType e) {
        vtkIdType n = 0;
        const vtkIdType* points = nullptr;
        grid_->GetCellPoints(e, n, points);
        for (vtkIdType i = 0; i < n; ++i)
            if (points[i] < 0 || points[i] >= grid_->GetNumberOfPoints())
                fail(fmt::format("cell {} refers to point {} of {}", e, points[i], grid_->GetNumberOfPoints()));
        const auto node = [&](vtkIdType i) { return static_cast<int>(points[i]); };
        const int type = grid_->GetCellType(e);
        const bool isLine = (type == VTK_LINE || type == VTK_POLY_LINE) && n >= 2;
        if (type == VTK_VERTEX || type == VTK_POLY_VERTEX) return;
        if constexpr (Dim == 2) {
            if (type == VTK_TRIANGLE && n == 3)
                mesh_.cells.push_back({{node(0), node(1), node(2)}, group(2, e)});
            else if (isLine)
                for (vtkIdType i = 0; i + 1 < n; ++i) mesh_.faces.push_back({{node(i), node(i + 1)}, group(1, e)});
            else
                fail(fmt::format("cell {} is neither a triangle nor a line (VTK's type {})", e, type));
        } else {
            if (type == VTK_TETRA && n == 4)
                mesh_.cells.push_back({{node(0), node(1), node(2), node(3)}, group(3, e)});
            else if (type == VTK_TRIANGLE && n == 3)
                mesh_.faces.push_back({{node(0), node(1), node(2)}, group(2, e)});
            else if (!isLine)
                fail(fmt::format("cell {} is neither a tetrahedron nor a triangle (VTK's type {})", e, type));
        }
    }

    int group(int dimension, vtkIdType e) {
        const double value = values_ != nullptr ? values_->GetTuple1(e) : 0;
        std::string name = fmt::format("{}", value);
        if (words_ != nullptr && value >= 0 && value < static_cast<double>(words_->GetNumberOfValues()))
            name = words_->GetValue(static_cast<vtkIdType>(value));
        if (const int known = mesh_.groupNamed(dimension, name); known >= 0) return known;
        mesh_.groups.push_back({dimension, name});
        return static_cast<int>(mesh_.groups.size()) - 1;
    }

    vtkSmartPointer<vtkUnstructuredGrid> grid_;
    vtkDataArray* values_ = nullptr;
    vtkStringArray* words_ = nullptr;
    ForeignMeshOf<Dim> mesh_;
};

}  // namespace

template <int Dim>
ForeignMeshOf<Dim> readGridMesh(const std::filesystem::path& file, const std::string& cellArray) {
    // VTK's reader dies of some damaged files; those of our own form can be checked before.
    const std::string text = readText(file);
    if (text.find("vtkZLibDataCompressor") != std::string::npos &&
        text.find("<AppendedData encoding=\"raw\">") != std::string::npos)
        if (const Damage damage = damageOf(text); !damage.reason.empty() && !damage.foreign)
            throw UserError("cannot read \"" + file.string() + "\": truncated or corrupt (" + damage.reason + ")",
                            {file.string(), damage.line});
    return GridMeshReader<Dim>(file, cellArray).read();
}

template ForeignMeshOf<2> readGridMesh<2>(const std::filesystem::path&, const std::string&);
template ForeignMeshOf<3> readGridMesh<3>(const std::filesystem::path&, const std::string&);

}  // namespace pfem
