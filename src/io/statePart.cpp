#include "io/statePart.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/atomicFile.hpp"
#include "io/gridArrays.hpp"
#include "io/gridCheck.hpp"
#include "io/gridFile.hpp"
#include "io/stateGrid.hpp"

namespace pfem {

namespace {

template <int Dim>
Points<Dim> toPoints(vtkDataArray* array, const CheckedArrays& checked, const std::string& name) {
    Points<Dim> points(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        double xyz[3];
        array->GetTuple(static_cast<vtkIdType>(i), xyz);
        for (int c = 0; c < Dim; ++c) points[i][c] = xyz[c];
        if (Dim == 2 && xyz[2] != 0.0) checked.fail("array '" + name + "' leaves the plane z = 0 of a 2D case");
    }
    return points;
}

std::vector<double> toScalars(vtkDoubleArray* array) {
    return {array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues()};
}

/// Indices of faces, or -1 for none.
template <int Dim>
std::vector<Supports<Dim>> toSupports(const CheckedArrays& arrays, const std::string& name) {
    const auto all = arrays.integers(name, Dim);
    std::vector<Supports<Dim>> supports(all.size() / Dim);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k] < -1 || all[k] > std::numeric_limits<int>::max())
            arrays.fail(fmt::format("array '{}' contains {}, which is no face", name, all[k]));
        supports[k / Dim][k % Dim] = static_cast<int>(all[k]);
    }
    return supports;
}

template <int Dim>
std::vector<Stress<Dim>> readStress(const CheckedArrays& arrays) {
    auto* sigma = arrays.doubles("sigma", 6);
    std::vector<Stress<Dim>> stress(static_cast<std::size_t>(sigma->GetNumberOfTuples()));
    for (std::size_t i = 0; i < stress.size(); ++i)
        for (int c = 0; c < nStress<Dim>; ++c) stress[i][c] = sigma->GetTypedComponent(static_cast<vtkIdType>(i), c);
    return stress;
}

/// The arrays with these names, one number a tuple.
History readHistory(const CheckedArrays& arrays, const std::vector<std::string>& names) {
    History history{names, {}};
    for (int k = 0; k < history.width(); ++k) {
        auto* column = arrays.doubles(names[static_cast<std::size_t>(k)], 1);
        const int n = static_cast<int>(column->GetNumberOfTuples());
        history.resize(n);
        for (int i = 0; i < n; ++i) history.at(i, k) = column->GetValue(i);
    }
    return history;
}

template <int Dim>
Nodes<Dim> readNodes(vtkUnstructuredGrid* grid, const std::filesystem::path& file, bool& hasStress) {
    const CheckedArrays arrays(file, grid->GetPointData(), grid->GetNumberOfPoints());
    Nodes<Dim> nodes;
    auto* positions = vtkDoubleArray::SafeDownCast(grid->GetPoints()->GetData());
    if (positions == nullptr) arrays.fail("array 'Points' is not of type Float64");
    for (vtkIdType i = 0; i < positions->GetNumberOfValues(); ++i)
        if (!std::isfinite(positions->GetValue(i))) arrays.fail("array 'Points' contains a value that is not finite");
    hasStress = arrays.found("sigma");
    Nodes<Dim>::fields([&](const std::string& name, auto field, const auto& first, auto) {
        auto& values = nodes.*field;
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Value, Id>) {
            values = arrays.integers(name);
        } else if constexpr (std::is_same_v<Value, Supports<Dim>>) {
            values = toSupports<Dim>(arrays, name);
        } else if constexpr (std::is_same_v<Value, double>) {
            values = toScalars(arrays.doubles(name, 1));
        } else if constexpr (std::is_same_v<Value, Stress<Dim>>) {
            if (hasStress) values = readStress<Dim>(arrays);
            values.resize(nodes.id.size(), first);
        } else {
            values = toPoints<Dim>(name == "Points" ? positions : arrays.doubles(name, 3), arrays, name);
        }
    });
    for (std::size_t i = 0; i < nodes.id.size(); ++i)
        if (nodes.id[i] < 0 || (i > 0 && nodes.id[i] <= nodes.id[i - 1])) arrays.fail("array 'id' does not ascend");
    return nodes;
}

template <int Dim>
void readCells(vtkUnstructuredGrid* grid, Part<Dim>& part) {
    const vtkIdType nPoints = grid->GetNumberOfPoints();
    for (vtkIdType e = 0; e < grid->GetNumberOfCells(); ++e) {
        vtkIdType n = 0;
        const vtkIdType* points = nullptr;
        grid->GetCellPoints(e, n, points);
        std::vector<Id> ids;
        for (vtkIdType i = 0; i < n; ++i) {
            if (points[i] < 0 || points[i] >= nPoints)
                part.fail(fmt::format("array 'connectivity': cell {} refers to point {} of {}", e, points[i], nPoints));
            ids.push_back(part.nodes.id[static_cast<std::size_t>(points[i])]);
        }
        std::vector<Id> sorted = ids;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
            part.fail(fmt::format("array 'connectivity': cell {} has the same node twice", e));
        part.types.push_back(grid->GetCellType(e));
        part.cells.push_back(std::move(ids));
    }
}

/// VTK's reader dies of some damaged files (a division by zero in its decompression, unknown types), so that a file is
/// trusted only when its checksum is right and what it says of itself makes sense. The word `none` in uniform/time
/// leaves the checksum out.
void checkSum(const std::filesystem::path& file, const std::string& name, const UniformTime& uniform) {
    const auto sum = uniform.checksums.find(name);
    const std::string text = readText(file);
    const Damage damage = damageOf(text);
    const auto fail = [&](const std::string& reason) {
        const std::string more = damage.reason.empty() ? "" : "; " + damage.reason;
        throw UserError("cannot read \"" + file.string() + "\": " + reason + more, {file.string(), damage.line});
    };
    if (sum == uniform.checksums.end()) fail("entry 'checksums' in uniform/time has no word for it");
    if (sum->second != "none" && sum->second != checksumOf(text))
        fail("truncated or corrupt, it does not fit entry 'checksums' in uniform/time");
    if (!damage.reason.empty()) fail("truncated or corrupt");
}

}  // namespace

template <int Dim>
Part<Dim> readPart(const std::filesystem::path& folder, const std::string& name, const std::string& values,
                   const UniformTime& uniform) {
    const std::filesystem::path file = folder / name;
    Part<Dim> part;
    part.file = file.string();
    checkSum(file, name, uniform);
    const auto grid = readGrid(file);
    part.nodes = readNodes<Dim>(grid, file, part.hasStress);
    readCells(grid.Get(), part);
    const CheckedArrays cells(file, grid->GetCellData(), grid->GetNumberOfCells());
    part.values = cells.integers(values);
    if (cells.found("sigma")) part.cellStress = readStress<Dim>(cells);
    const CheckedArrays field(file, grid->GetFieldData(), -1);
    part.materials = field.words("materials");
    if (field.found("history")) {
        const auto names = field.words("history");
        part.nodes.history = readHistory(CheckedArrays(file, grid->GetPointData(), grid->GetNumberOfPoints()), names);
        if (!names.empty() && cells.found(names[0])) part.cellHistory = readHistory(cells, names);
    }
    if (name == stateGrid::boundaryFile) part.patchNames = field.words("patchNames");
    if (vtkDoubleArray* time = field.doubles("TimeValue", 1);
        time->GetNumberOfTuples() != 1 || time->GetValue(0) != uniform.time.value)
        part.fail("array 'TimeValue' is not the time in uniform/time");
    return part;
}

template Part<2> readPart<2>(const std::filesystem::path&, const std::string&, const std::string&, const UniformTime&);
template Part<3> readPart<3>(const std::filesystem::path&, const std::string&, const std::string&, const UniformTime&);

}  // namespace pfem
