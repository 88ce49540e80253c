#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "base/error.hpp"
#include "io/atomicFile.hpp"
#include "io/gridArrays.hpp"
#include "io/gridFile.hpp"
#include "io/stateFiles.hpp"
#include "io/stateGrid.hpp"
#include "io/uniformTime.hpp"

namespace pfem {

using namespace stateGrid;

namespace {

/// One file, checked: its nodes, and per cell the type, the ids of its nodes and its integer.
template <int Dim>
struct Part {
    std::string file;
    Nodes<Dim> nodes;
    bool hasStress = false;
    std::vector<int> types;
    std::vector<std::vector<Id>> cells;
    std::vector<Id> values;
    std::vector<std::string> materials;
    std::vector<std::string> patchNames;  // boundary.vtu only

    [[noreturn]] void fail(const std::string& reason) const {
        throw UserError("cannot read \"" + file + "\": " + reason, {file, 0});
    }
};

template <int Dim>
Points<Dim> toPoints(vtkDataArray* array, const CheckedArrays& checked, const std::string& name) {
    Points<Dim> points(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        double xyz[3];
        array->GetTuple(static_cast<vtkIdType>(i), xyz);
        for (int c = 0; c < Dim; ++c) points[i][c] = xyz[c];
        if (Dim == 2 && xyz[2] != 0.0) checked.fail("'" + name + "' leaves the plane z = 0 of a 2D case");
    }
    return points;
}

std::vector<double> toScalars(vtkDoubleArray* array) {
    return {array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues()};
}

template <int Dim>
Nodes<Dim> readNodes(vtkUnstructuredGrid* grid, const std::filesystem::path& file, bool& hasStress) {
    const CheckedArrays arrays(file, grid->GetPointData(), grid->GetNumberOfPoints());
    auto points = [&](const std::string& name) {
        return toPoints<Dim>(arrays.doubles(name, 3), arrays, name);
    };
    Nodes<Dim> nodes;
    nodes.id = arrays.integers("id");
    auto* positions = vtkDoubleArray::SafeDownCast(grid->GetPoints()->GetData());
    if (positions == nullptr) arrays.fail("the points are not of type Float64");
    for (vtkIdType i = 0; i < positions->GetNumberOfValues(); ++i)
        if (!std::isfinite(positions->GetValue(i))) arrays.fail("a point's position is not finite");
    nodes.x = toPoints<Dim>(positions, arrays, "Points");
    nodes.v = points("U");
    nodes.a = points("a");
    nodes.p = toScalars(arrays.doubles("p", 1));
    nodes.X = points("X");
    nodes.h = toScalars(arrays.doubles("h", 1));
    nodes.dropVolume = toScalars(arrays.doubles("dropVolume", 1));
    nodes.sigma.assign(nodes.id.size(), Stress<Dim>::Zero());
    hasStress = arrays.found("sigma");
    if (hasStress) {
        auto* sigma = arrays.doubles("sigma", 6);
        for (std::size_t i = 0; i < nodes.sigma.size(); ++i)
            for (int c = 0; c < nStress<Dim>; ++c)
                nodes.sigma[i][c] = sigma->GetTypedComponent(static_cast<vtkIdType>(i), c);
    }
    for (std::size_t i = 0; i < nodes.id.size(); ++i)
        if (nodes.id[i] < 0 || (i > 0 && nodes.id[i] <= nodes.id[i - 1]))
            arrays.fail("the node ids do not ascend");
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
                part.fail(fmt::format("cell {} refers to point {} of {}", e, points[i], nPoints));
            ids.push_back(part.nodes.id[static_cast<std::size_t>(points[i])]);
        }
        std::vector<Id> sorted = ids;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
            part.fail(fmt::format("cell {} has the same node twice", e));
        part.types.push_back(grid->GetCellType(e));
        part.cells.push_back(std::move(ids));
    }
}

/// VTK's reader dies of some damaged files (a division by zero in its decompression), so that a file is
/// trusted only when its checksum is right. The word `none` in uniform/time leaves the check out.
void checkSum(const std::filesystem::path& file, const std::string& name, const UniformTime& uniform) {
    const auto sum = uniform.checksums.find(name);
    const std::string text = readText(file);
    if (sum == uniform.checksums.end())
        throw UserError("cannot read \"" + file.string() + "\": uniform/time has no checksum for it",
                        {file.string(), 0});
    if (sum->second != "none" && sum->second != checksumOf(text))
        throw UserError(
            "cannot read \"" + file.string() + "\": truncated or corrupt (not the checksum in uniform/time)",
            {file.string(), 0});
}

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
    part.values = CheckedArrays(file, grid->GetCellData(), grid->GetNumberOfCells()).integers(values);
    const CheckedArrays field(file, grid->GetFieldData(), -1);
    part.materials = field.words("materials");
    if (name == boundaryFile) part.patchNames = field.words("patchNames");
    if (vtkDoubleArray* time = field.doubles("TimeValue", 1);
        time->GetNumberOfTuples() != 1 || time->GetValue(0) != uniform.time.value)
        part.fail("its time is not the one in uniform/time");
    return part;
}

template <int Dim>
bool sameBits(const Nodes<Dim>& a, std::size_t i, const Nodes<Dim>& b, std::size_t j) {
    auto same = [](const auto& s, const auto& t) {
        return std::memcmp(s.data(), t.data(), sizeof(double) * static_cast<std::size_t>(s.size())) == 0;
    };
    auto equal = [](double s, double t) { return std::memcmp(&s, &t, sizeof s) == 0; };
    return same(a.x[i], b.x[j]) && same(a.v[i], b.v[j]) && same(a.a[i], b.a[j]) && same(a.X[i], b.X[j]) &&
           equal(a.p[i], b.p[j]) && equal(a.h[i], b.h[j]) && equal(a.dropVolume[i], b.dropVolume[j]);
}

/// All parts' nodes by ascending id; the first part that has a node gives its values (solid first: it has
/// the stress). Nodes in several files must agree.
template <int Dim>
Nodes<Dim> mergeNodes(const std::vector<const Part<Dim>*>& parts) {
    struct Source {
        Id id;
        std::size_t part, node;
    };
    std::vector<Source> sources;
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (std::size_t i = 0; i < parts[k]->nodes.id.size(); ++i)
            sources.push_back({parts[k]->nodes.id[i], k, i});
    std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) {
        return std::tie(a.id, a.part) < std::tie(b.id, b.part);
    });
    Nodes<Dim> nodes;
    for (const Source& s : sources) {
        const Nodes<Dim>& from = parts[s.part]->nodes;
        if (nodes.id.empty() || nodes.id.back() != s.id)
            nodes.append(from, static_cast<int>(s.node));
        else if (!sameBits(nodes, nodes.id.size() - 1, from, s.node))
            parts[s.part]->fail(
                fmt::format("node {} has other values than in another file of the folder", s.id));
    }
    return nodes;
}

template <int Dim>
int indexOf(const Nodes<Dim>& nodes, Id id) {
    return static_cast<int>(std::lower_bound(nodes.id.begin(), nodes.id.end(), id) - nodes.id.begin());
}

template <std::size_t N, int Dim>
std::array<int, N> toIndices(const std::vector<Id>& ids, const Nodes<Dim>& nodes) {
    std::array<int, N> indices{};
    for (std::size_t i = 0; i < N; ++i) indices[i] = indexOf(nodes, ids[i]);
    return indices;
}

template <int Dim>
Cells<Dim> simplicesOf(const Part<Dim>& part, const Nodes<Dim>& nodes, bool withParticles) {
    Cells<Dim> cells;
    for (std::size_t e = 0; e < part.cells.size(); ++e) {
        if (withParticles && part.types[e] == VTK_VERTEX) continue;
        if (part.types[e] != simplexType<Dim> || part.cells[e].size() != Dim + 1)
            part.fail(fmt::format("cell {} has the unexpected type {}", e, part.types[e]));
        if (part.values[e] < 0 || part.values[e] >= static_cast<Id>(part.materials.size()))
            part.fail(fmt::format("cell {} has material {} of {}", e, part.values[e], part.materials.size()));
        cells.nodes.push_back(toIndices<Dim + 1>(part.cells[e], nodes));
        cells.material.push_back(static_cast<int>(part.values[e]));
    }
    return cells;
}

template <int Dim>
std::vector<Patch<Dim>> patchesOf(const Part<Dim>& part, const Nodes<Dim>& nodes) {
    std::vector<Patch<Dim>> patches;
    for (const auto& name : part.patchNames) patches.push_back({name, {}});
    for (std::size_t f = 0; f < part.cells.size(); ++f) {
        if (part.types[f] != faceType<Dim> || part.cells[f].size() != Dim)
            part.fail(fmt::format("face {} has the unexpected type {}", f, part.types[f]));
        if (part.values[f] < 0 || part.values[f] >= static_cast<Id>(patches.size()))
            part.fail(fmt::format("face {} belongs to patch {} of {}", f, part.values[f], patches.size()));
        patches[static_cast<std::size_t>(part.values[f])].faces.push_back(
            toIndices<Dim>(part.cells[f], nodes));
    }
    return patches;
}

}  // namespace

template <int Dim>
State<Dim> readState(const std::filesystem::path& folder) {
    const UniformTime uniform = readUniformTime(folder);
    const auto fluid = readPart<Dim>(folder, fluidFile, "material", uniform);
    const auto solid = readPart<Dim>(folder, solidFile, "material", uniform);
    const auto boundary = readPart<Dim>(folder, boundaryFile, "patch", uniform);
    if (!solid.hasStress) solid.fail("array 'sigma' is missing");
    if (solid.materials != fluid.materials) solid.fail("its materials are not those of " + fluidFile);

    State<Dim> state;
    state.time = uniform.time;
    state.nextId = uniform.nextId;
    state.ledger = uniform.ledger;
    state.nodes = mergeNodes<Dim>({&solid, &fluid, &boundary});
    if (!state.nodes.id.empty() && state.nodes.id.back() >= state.nextId)
        fluid.fail(fmt::format("node {} is not below nextId {} in uniform/time", state.nodes.id.back(),
                               state.nextId));
    state.mesh.fluid = simplicesOf(fluid, state.nodes, true);
    state.mesh.solid = simplicesOf(solid, state.nodes, false);
    state.mesh.patches = patchesOf(boundary, state.nodes);
    state.mesh.materials = fluid.materials;
    return state;
}

template State<2> readState<2>(const std::filesystem::path&);

}  // namespace pfem
