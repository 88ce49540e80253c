#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

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

/// The nodes of one file: ascending indices into the state and the way back (-1: not in this file).
struct NodeSet {
    std::vector<int> nodes;
    std::vector<int> local;

    explicit NodeSet(const std::vector<char>& member) : local(member.size(), -1) {
        for (std::size_t i = 0; i < member.size(); ++i) {
            if (member[i] == 0) continue;
            local[i] = static_cast<int>(nodes.size());
            nodes.push_back(static_cast<int>(i));
        }
    }
    int size() const { return static_cast<int>(nodes.size()); }
};

template <class CellList>
void mark(std::vector<char>& member, const CellList& cells) {
    for (const auto& cell : cells)
        for (const int i : cell) {
            if (i < 0 || i >= static_cast<int>(member.size()))
                throw InternalError(
                    fmt::format("writeState: cell refers to node {} of {}", i, member.size()));
            member[static_cast<std::size_t>(i)] = 1;
        }
}

/// Which nodes go into which file; a node may be in several, and is in one at least.
template <int Dim>
struct Membership {
    std::vector<char> fluid, solid, boundary;
    std::vector<int> isolated;  // in no cell and no patch

    explicit Membership(const State<Dim>& state) {
        const auto n = static_cast<std::size_t>(state.nodes.size());
        fluid.assign(n, 0);
        solid.assign(n, 0);
        boundary.assign(n, 0);
        mark(fluid, state.mesh.fluid.nodes);
        mark(solid, state.mesh.solid.nodes);
        for (const auto& patch : state.mesh.patches) mark(boundary, patch.faces);
        for (std::size_t i = 0; i < n; ++i)
            if (fluid[i] + solid[i] + boundary[i] == 0) {
                fluid[i] = 1;
                isolated.push_back(static_cast<int>(i));
            }
    }
};

template <int Dim>
double component(const Vec<Dim>& vector, int c) {
    return c < Dim ? vector[c] : 0.0;
}

/// Is there a stress at a node that solid.vtu does not hold? (Bits count: -0.0 is not 0.0.)
template <int Dim>
bool stressOutsideSolid(const State<Dim>& state, const NodeSet& set, const std::vector<char>& solid) {
    for (const int i : set.nodes)
        for (int c = 0; c < nStress<Dim> && solid[i] == 0; ++c)
            if (state.nodes.sigma[i][c] != 0.0 || std::signbit(state.nodes.sigma[i][c])) return true;
    return false;
}

template <int Dim>
void addNodes(vtkUnstructuredGrid* grid, const State<Dim>& state, const NodeSet& set, bool withStress,
              const ExtraFields& extra) {
    const Nodes<Dim>& all = state.nodes;
    const int n = set.size();
    auto at = [&](int i) { return static_cast<std::size_t>(set.nodes[static_cast<std::size_t>(i)]); };

    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetData(makeArray<vtkDoubleArray>("Points", 3, n,
                                              [&](int i, int c) { return component<Dim>(all.x[at(i)], c); }));
    grid->SetPoints(points);

    vtkPointData* data = grid->GetPointData();
    auto vectors = [&](const std::string& name, const Points<Dim>& values) {
        data->AddArray(makeArray<vtkDoubleArray>(
            name, 3, n, [&](int i, int c) { return component<Dim>(values[at(i)], c); }));
    };
    auto scalars = [&](const std::string& name, const std::vector<double>& values) {
        data->AddArray(makeArray<vtkDoubleArray>(name, 1, n, [&](int i, int) { return values[at(i)]; }));
    };
    data->SetGlobalIds(makeArray<vtkIdTypeArray>("id", 1, n, [&](int i, int) { return all.id[at(i)]; }));
    vectors("U", all.v);
    vectors("a", all.a);
    scalars("p", all.p);
    data->AddArray(makeArray<vtkDoubleArray>("D", 3, n, [&](int i, int c) {
        return component<Dim>(all.x[at(i)], c) - component<Dim>(all.X[at(i)], c);
    }));
    vectors("X", all.X);
    if (withStress) {
        auto sigma = makeArray<vtkDoubleArray>(
            "sigma", 6, n, [&](int i, int c) { return c < nStress<Dim> ? all.sigma[at(i)][c] : 0.0; });
        for (int c = 0; c < 6; ++c) sigma->SetComponentName(c, tensorComponents[static_cast<std::size_t>(c)]);
        data->AddArray(sigma);
    }
    scalars("h", all.h);
    scalars("dropVolume", all.dropVolume);
    for (const auto& [name, values] : extra.nodal) scalars(name, values);
    for (const auto& [name, values] : extra.nodalFlags)
        data->AddArray(makeArray<vtkUnsignedCharArray>(
            name, 1, n, [&, &flags = values](int i, int) { return flags[at(i)]; }));
    data->SetActiveVectors("U");
    data->SetActiveScalars("p");
}

/// Collects the cells of a grid, their types and their one integer array.
class CellBuilder {
public:
    template <class Cell>
    void add(int type, const Cell& cell, const NodeSet& set, int value) {
        cells_->InsertNextCell(static_cast<int>(cell.size()));
        for (const int i : cell) cells_->InsertCellPoint(set.local[static_cast<std::size_t>(i)]);
        types_->InsertNextValue(static_cast<unsigned char>(type));
        values_->InsertNextValue(value);
    }
    void finish(vtkUnstructuredGrid* grid, const std::string& valueName) {
        values_->SetName(valueName.c_str());
        grid->SetCells(types_, cells_);
        grid->GetCellData()->AddArray(values_);
    }

private:
    vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
    vtkSmartPointer<vtkUnsignedCharArray> types_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
    vtkSmartPointer<vtkIntArray> values_ = vtkSmartPointer<vtkIntArray>::New();
};

template <int Dim>
void addSimplices(CellBuilder& builder, const Cells<Dim>& cells, const NodeSet& set) {
    for (std::size_t e = 0; e < cells.nodes.size(); ++e)
        builder.add(simplexType<Dim>, cells.nodes[e], set, cells.material[e]);
}

template <int Dim>
vtkSmartPointer<vtkUnstructuredGrid> newGrid(const State<Dim>& state) {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkFieldData* field = grid->GetFieldData();
    field->AddArray(makeArray<vtkDoubleArray>("TimeValue", 1, 1, [&](int, int) { return state.time.value; }));
    field->AddArray(makeWords("materials", state.mesh.materials));
    return grid;
}

template <int Dim>
void checkSizes(const State<Dim>& state, const ExtraFields& extra) {
    const Nodes<Dim>& nodes = state.nodes;
    const std::size_t n = nodes.id.size();
    bool ok = nodes.x.size() == n && nodes.v.size() == n && nodes.a.size() == n && nodes.p.size() == n &&
              nodes.sigma.size() == n && nodes.X.size() == n && nodes.h.size() == n &&
              nodes.dropVolume.size() == n;
    for (std::size_t i = 1; i < n && ok; ++i) ok = nodes.id[i - 1] < nodes.id[i];
    if (!ok) throw InternalError("writeState: nodal arrays differ in length or ids do not ascend");
    if (n > 0 && nodes.id.back() >= state.nextId)
        throw InternalError("writeState: nextId is not above all ids");
    for (const Cells<Dim>* cells : {&state.mesh.fluid, &state.mesh.solid})
        if (cells->nodes.size() != cells->material.size())
            throw InternalError("writeState: the number of materials is not the number of cells");
    for (const auto& [name, values] : extra.nodal)
        if (values.size() != n)
            throw InternalError("writeState: extra field '" + name + "' has a wrong length");
    for (const auto& [name, values] : extra.nodalFlags)
        if (values.size() != n)
            throw InternalError("writeState: extra field '" + name + "' has a wrong length");
}

}  // namespace

template <int Dim>
void writeState(const std::filesystem::path& folder, const State<Dim>& state, const ExtraFields& extra) {
    checkSizes(state, extra);
    const Membership<Dim> members(state);
    StagedFolder staged(folder);

    const NodeSet fluidNodes(members.fluid);
    auto fluid = newGrid(state);
    addNodes(fluid.Get(), state, fluidNodes, stressOutsideSolid(state, fluidNodes, members.solid), extra);
    CellBuilder fluidCells;
    addSimplices(fluidCells, state.mesh.fluid, fluidNodes);
    for (const int i : members.isolated)
        fluidCells.add(VTK_VERTEX, std::array<int, 1>{i}, fluidNodes, noMaterial);
    fluidCells.finish(fluid, "material");
    writeGrid(staged.path() / fluidFile, fluid);

    const NodeSet solidNodes(members.solid);
    auto solid = newGrid(state);
    addNodes(solid.Get(), state, solidNodes, true, extra);
    CellBuilder solidCells;
    addSimplices(solidCells, state.mesh.solid, solidNodes);
    solidCells.finish(solid, "material");
    writeGrid(staged.path() / solidFile, solid);

    const NodeSet boundaryNodes(members.boundary);
    auto boundary = newGrid(state);
    addNodes(boundary.Get(), state, boundaryNodes, stressOutsideSolid(state, boundaryNodes, members.solid),
             extra);
    CellBuilder boundaryCells;
    std::vector<std::string> names;
    for (const auto& patch : state.mesh.patches) {
        for (const auto& face : patch.faces)
            boundaryCells.add(faceType<Dim>, face, boundaryNodes, static_cast<int>(names.size()));
        names.push_back(patch.name);
    }
    boundaryCells.finish(boundary, "patch");
    boundary->GetFieldData()->AddArray(makeWords("patchNames", names));
    writeGrid(staged.path() / boundaryFile, boundary);

    UniformTime uniform{state.time, state.nextId, state.ledger, {}};
    for (const auto& file : files) uniform.checksums[file] = checksumOf(readText(staged.path() / file));
    std::filesystem::create_directory(staged.path() / "uniform");
    writeAtomically(staged.path() / "uniform" / "time",
                    formatUniformTime(uniform, folder.filename().string()));
    staged.commit();
}

template void writeState<2>(const std::filesystem::path&, const State<2>&, const ExtraFields&);

}  // namespace pfem
