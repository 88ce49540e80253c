// Is the mesh of a written time sound, and what will the solver take for free surface? Exit code 1 when it is
// not.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "application/dimension.hpp"
#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "conditions/boundaryConditions.hpp"
#include "io/stateFiles.hpp"
#include "mesh/checkMesh.hpp"
#include "mesh/simplex.hpp"
#include "solver/setup.hpp"
#include "solver/sharedPlaces.hpp"

using namespace pfem;

namespace {

/// "0.1 0.2", "0.1 0.2 0.3"
template <int Dim>
std::string coordinates(const Vec<Dim>& x) {
    std::string text = fmt::format("{:.6g} {:.6g}", x[0], x[1]);
    if (Dim == 3) text += fmt::format(" {:.6g}", x[Dim - 1]);
    return text;
}

template <int Dim>
void printShapes(const char* kind, const Cells<Dim>& cells, const CellShapes& shapes, const Points<Dim>& x) {
    if (cells.size() == 0) return;
    if (Dim == 2)
        fmt::print("{}: {} triangles, quality 2 r/R (1: equilateral)\n", kind, cells.size());
    else
        fmt::print("{}: {} tetrahedra, quality 3 r/R (1: regular)\n", kind, cells.size());
    for (std::size_t k = 0; k < shapes.histogram.size(); ++k)
        if (shapes.histogram[k] > 0)
            fmt::print("  {:.1f} - {:.1f} {:>9} {}\n", 0.1 * static_cast<double>(k), 0.1 * static_cast<double>(k + 1),
                       shapes.histogram[k],
                       std::string(static_cast<std::size_t>(50.0 * shapes.histogram[k] / cells.size()), '#'));
    const Vec<Dim> worst = simplexCentroid<Dim>(x, cells.nodes[static_cast<std::size_t>(shapes.worstCell)]);
    fmt::print("  worst {:.3f} at ({})\n", shapes.worst, coordinates<Dim>(worst));
}

template <int Dim>
void printFaults(const std::vector<MeshFault<Dim>>& faults, const char* mark) {
    constexpr std::size_t shown = 10;
    for (std::size_t k = 0; k < std::min(shown, faults.size()); ++k)
        fmt::print("  {}{} at ({})\n", mark, faults[k].what, coordinates<Dim>(faults[k].where));
    if (faults.size() > shown) fmt::print("  {}and {} more\n", mark, faults.size() - shown);
}

/// False when there are faults.
template <int Dim>
bool printCheck(const State<Dim>& state, const MeshCheck<Dim>& check) {
    printShapes<Dim>("Fluid", state.mesh.fluid, check.fluid, state.nodes.x);
    printShapes<Dim>("Solid", state.mesh.solid, check.solid, state.nodes.x);
    if (const char* unit = Dim == 2 ? "m" : "m2"; state.mesh.fluid.size() > 0)
        fmt::print("Boundary of the fluid: free surface {:.6g} {} in {} pieces, walls {:.6g} {}, solids {:.6g} {}\n",
                   check.freeSurface, unit, check.pieces, check.wetWalls, unit, check.interface, unit);
    const auto& drops = state.nodes.dropVolume;
    if (const auto n = std::count_if(drops.begin(), drops.end(), [](double volume) { return volume > 0; }); n > 0)
        fmt::print("Drops in flight: {} nodes, {:.3g} m{}\n", n, std::accumulate(drops.begin(), drops.end(), 0.0), Dim);
    printFaults<Dim>(check.faults, "***");
    printFaults<Dim>(check.gaps, "*");
    // while a run goes on, a narrow gap is a contact to come
    const std::size_t failed = check.faults.size() + (state.time.index == 0 ? check.gaps.size() : 0);
    fmt::print("{}\n\n", failed == 0 ? "Mesh OK." : fmt::format("Failed {} mesh checks.", failed));
    return failed == 0;
}

template <int Dim>
BoundaryConditions<Dim> patchConditions(const Case& theCase, const State<Dim>& state) {
    if constexpr (Dim == 2) return readProblem<2>(theCase, state).conditions;
    const Dictionary conditions = Dictionary::read(theCase.constant("boundaryConditions"));
    return readBoundaryConditions<Dim>(conditions, state.mesh.patches);
}

template <int Dim>
bool checkTime(const Case& theCase, const std::string& time) {
    const State<Dim> state = readState<Dim>(theCase.time(time));
    const auto conditions = patchConditions<Dim>(theCase, state);
    const auto topology = makeTopology<Dim>(state.mesh, conditions.kind, state.nodes.x, state.nodes.wall);
    fmt::print("Time = {}\n\n", time);
    fmt::print("{}", sharedPlacesText<Dim>(conditions, std::filesystem::exists(theCase.constant("contact")), state));
    return printCheck<Dim>(state, checkMesh<Dim>(state.mesh, topology, state.nodes.x, state.nodes.h));
}

}  // namespace

int main(int argc, char** argv) {
    OptionsSpec spec;
    spec.addTimeSelection();
    return runApplication(argc, argv, "Check the mesh of the written times.", spec, [](const Options& options) {
        const Case theCase = options.openCase();
        bool good = true;
        for (const auto& time : selectTimes(theCase, options)) {
            const bool sound = withDimension(
                theCase.time(time.name), [&](auto dim) { return checkTime<decltype(dim)::value>(theCase, time.name); });
            good = sound && good;
        }
        fmt::print("End\n\n");
        return good ? 0 : 1;
    });
}
