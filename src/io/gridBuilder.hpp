#pragma once
// Nodes and cells of a state as parts of a VTK grid. Internal to src/io.

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

#include "io/gridArrays.hpp"
#include "io/nodeSets.hpp"
#include "io/stateFiles.hpp"
#include "io/stateGrid.hpp"

namespace pfem {

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

/// Stresses in VTK's six components; `at(i)` is the index of tuple i.
template <int Dim, class Index>
vtkSmartPointer<vtkDoubleArray> makeStress(const std::vector<Stress<Dim>>& stress, int n, const Index& at) {
    auto sigma = makeArray<vtkDoubleArray>("sigma", 6, n,
                                           [&](int i, int c) { return c < nStress<Dim> ? stress[at(i)][c] : 0.0; });
    for (int c = 0; c < 6; ++c) sigma->SetComponentName(c, stateGrid::tensorComponents[static_cast<std::size_t>(c)]);
    return sigma;
}

/// What laws remember, an array for each number; `at(i)` is the index of tuple i.
template <class Index>
void addHistory(vtkDataSetAttributes* data, const History& history, int n, const Index& at) {
    for (int k = 0; k < history.width(); ++k)
        data->AddArray(makeArray<vtkDoubleArray>(history.names[static_cast<std::size_t>(k)], 1, n,
                                                 [&](int i, int) { return history.at(static_cast<int>(at(i)), k); }));
}

/// D = x - X, for the eye.
template <int Dim, class Index>
void addDisplacement(vtkPointData* data, const Nodes<Dim>& nodes, int n, const Index& at) {
    data->AddArray(makeArray<vtkDoubleArray>("D", 3, n, [&](int i, int c) {
        return component<Dim>(nodes.x[at(i)], c) - component<Dim>(nodes.X[at(i)], c);
    }));
}

/// Points and point data of the nodes in `set`; the stress only where the file needs it.
template <int Dim>
void addNodes(vtkUnstructuredGrid* grid, const State<Dim>& state, const NodeSet& set, bool withStress,
              const ExtraFields& extra) {
    const Nodes<Dim>& all = state.nodes;
    const int n = set.size();
    auto at = [&](int i) { return static_cast<std::size_t>(set.nodes[static_cast<std::size_t>(i)]); };

    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetData(
        makeArray<vtkDoubleArray>("Points", 3, n, [&](int i, int c) { return component<Dim>(all.x[at(i)], c); }));
    grid->SetPoints(points);

    vtkPointData* data = grid->GetPointData();
    auto scalars = [&](const std::string& name, const std::vector<double>& values) {
        data->AddArray(makeArray<vtkDoubleArray>(name, 1, n, [&](int i, int) { return values[at(i)]; }));
    };
    Nodes<Dim>::fields([&](const std::string& name, auto field, const auto&, auto) {
        const auto& values = all.*field;
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Value, Id>) {
            data->SetGlobalIds(makeArray<vtkIdTypeArray>(name, 1, n, [&](int i, int) { return values[at(i)]; }));
        } else if constexpr (std::is_same_v<Value, Supports<Dim>>) {
            data->AddArray(makeArray<vtkIntArray>(name, Dim, n, [&](int i, int c) { return values[at(i)][c]; }));
        } else if constexpr (std::is_same_v<Value, double>) {
            scalars(name, values);
        } else if constexpr (std::is_same_v<Value, Stress<Dim>>) {
            if (withStress) data->AddArray(makeStress<Dim>(values, n, at));
        } else if (name != "Points") {  // those are the grid's
            if (name == "X") addDisplacement<Dim>(data, all, n, at);
            data->AddArray(
                makeArray<vtkDoubleArray>(name, 3, n, [&](int i, int c) { return component<Dim>(values[at(i)], c); }));
        }
    });
    for (const auto& [name, values] : extra.nodal) scalars(name, values);
    for (const auto& [name, values] : extra.nodalFlags)
        data->AddArray(
            makeArray<vtkUnsignedCharArray>(name, 1, n, [&, &flags = values](int i, int) { return flags[at(i)]; }));
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

}  // namespace pfem
