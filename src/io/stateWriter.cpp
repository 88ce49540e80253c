#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/gridBuilder.hpp"
#include "io/gridFile.hpp"
#include "io/sizesFile.hpp"
#include "io/stateFiles.hpp"
#include "io/stateGrid.hpp"
#include "io/uniformTime.hpp"
#include "state/images.hpp"

namespace pfem {

using namespace stateGrid;

namespace {

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
    bool ok = true;
    Nodes<Dim>::fields([&](const char*, auto field, const auto&, auto) { ok = ok && (nodes.*field).size() == n; });
    for (std::size_t i = 1; i < n && ok; ++i) ok = nodes.id[i - 1] < nodes.id[i];
    if (!ok) throw InternalError("writeState: nodal arrays differ in length or ids do not ascend");
    if (!namesAreValid<Dim>(state)) throw InternalError("writeState: nextId is not above all ids but those of images");
    for (const Cells<Dim>* cells : {&state.mesh.fluid, &state.mesh.solid})
        if (cells->nodes.size() != cells->material.size())
            throw InternalError("writeState: the number of materials is not the number of cells");
    const std::size_t stresses = state.mesh.solid.sigma.size();
    if ((stresses != 0 && stresses != state.mesh.solid.nodes.size()) || !state.mesh.fluid.sigma.empty())
        throw InternalError("writeState: the number of cell stresses is not the number of solid cells");
    const History &nodal = nodes.history, &ofCells = state.mesh.solid.history;
    if (nodal.values.size() != n * nodal.names.size() ||
        (!ofCells.empty() && (ofCells.values.size() != ofCells.names.size() * state.mesh.solid.nodes.size() ||
                              ofCells.names != nodal.names)))
        throw InternalError("writeState: the history of the solids has a wrong length or other names");
    for (const auto* fields : {&extra.nodal, &extra.ofFluid})
        for (const auto& [name, values] : *fields)
            if (values.size() != n) throw InternalError("writeState: extra field '" + name + "' has a wrong length");
    for (const auto& [name, values] : extra.nodalFlags)
        if (values.size() != n) throw InternalError("writeState: extra field '" + name + "' has a wrong length");
}

}  // namespace

template <int Dim>
void writeState(const std::filesystem::path& folder, const State<Dim>& state, const ExtraFields& extra) {
    checkSizes(state, extra);
    const Membership<Dim> members(state);
    StagedFolder staged(folder);

    const NodeSet fluidNodes(members.fluid);
    auto fluid = newGrid(state);
    ExtraFields ofFluid = extra;
    ofFluid.nodal.insert(extra.ofFluid.begin(), extra.ofFluid.end());
    addNodes(fluid.Get(), state, fluidNodes, stressOutsideSolid(state, fluidNodes, members.solid), ofFluid);
    CellBuilder fluidCells;
    addSimplices(fluidCells, state.mesh.fluid, fluidNodes);
    for (const int i : members.isolated) fluidCells.add(VTK_VERTEX, std::array<int, 1>{i}, fluidNodes, noMaterial);
    fluidCells.finish(fluid, "material");
    writeGrid(staged.path() / fluidFile, fluid);

    const NodeSet solidNodes(members.solid);
    auto solid = newGrid(state);
    addNodes(solid.Get(), state, solidNodes, true, extra);
    CellBuilder solidCells;
    addSimplices(solidCells, state.mesh.solid, solidNodes);
    solidCells.finish(solid, "material");
    if (const auto& stress = state.mesh.solid.sigma; !stress.empty())  // elemental integration
        solid->GetCellData()->AddArray(
            makeStress<Dim>(stress, state.mesh.solid.size(), [](int e) { return static_cast<std::size_t>(e); }));
    if (const History& history = state.nodes.history; !history.empty()) {
        solid->GetFieldData()->AddArray(makeWords("history", history.names));
        addHistory(solid->GetPointData(), history, solidNodes.size(),
                   [&](int i) { return solidNodes.nodes[static_cast<std::size_t>(i)]; });
    }
    addHistory(solid->GetCellData(), state.mesh.solid.history, state.mesh.solid.size(), [](int e) { return e; });
    writeGrid(staged.path() / solidFile, solid);

    const NodeSet boundaryNodes(members.boundary);
    auto boundary = newGrid(state);
    addNodes(boundary.Get(), state, boundaryNodes, stressOutsideSolid(state, boundaryNodes, members.solid), extra);
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

    UniformTime uniform{state.time, state.nextId, state.approach, state.ledger.byName(), state.energy.byName(),
                        {},         state.memory};
    for (const auto& file : files) uniform.checksums[file] = checksumOf(readText(staged.path() / file));
    std::filesystem::create_directory(staged.path() / "uniform");
    if (state.sizes.hold()) {
        const std::string sizes = formatSizes<Dim>(state.sizes, folder.filename().string());
        uniform.checksums["sizes"] = checksumOf(sizes);
        writeAtomically(staged.path() / "uniform" / "sizes", sizes);
    }
    writeAtomically(staged.path() / "uniform" / "time", formatUniformTime(uniform, folder.filename().string()));
    staged.commit();
}

template void writeState<2>(const std::filesystem::path&, const State<2>&, const ExtraFields&);
template void writeState<3>(const std::filesystem::path&, const State<3>&, const ExtraFields&);

}  // namespace pfem
