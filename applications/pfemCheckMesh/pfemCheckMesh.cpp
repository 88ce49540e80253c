// Is the mesh of a written time sound, and what will the solver take for free surface? Exit code 1 when it is
// not.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "io/stateFiles.hpp"
#include "mesh/checkMesh.hpp"
#include "mesh/simplex.hpp"
#include "solver/setup.hpp"

using namespace pfem;

namespace {

void printShapes(const char* kind, const Cells<2>& cells, const CellShapes& shapes, const Points<2>& x) {
    if (cells.size() == 0) return;
    fmt::print("{}: {} triangles, quality 2 r/R (1: equilateral)\n", kind, cells.size());
    for (std::size_t k = 0; k < shapes.histogram.size(); ++k)
        if (shapes.histogram[k] > 0)
            fmt::print("  {:.1f} - {:.1f} {:>9} {}\n", 0.1 * static_cast<double>(k), 0.1 * static_cast<double>(k + 1),
                       shapes.histogram[k],
                       std::string(static_cast<std::size_t>(50.0 * shapes.histogram[k] / cells.size()), '#'));
    const Vec<2> worst = simplexCentroid<2>(x, cells.nodes[static_cast<std::size_t>(shapes.worstCell)]);
    fmt::print("  worst {:.3f} at ({:.6g} {:.6g})\n", shapes.worst, worst[0], worst[1]);
}

void printFaults(const std::vector<MeshFault>& faults, const char* mark) {
    constexpr std::size_t shown = 10;
    for (std::size_t k = 0; k < std::min(shown, faults.size()); ++k)
        fmt::print("  {}{} at ({:.6g} {:.6g})\n", mark, faults[k].what, faults[k].where[0], faults[k].where[1]);
    if (faults.size() > shown) fmt::print("  {}and {} more\n", mark, faults.size() - shown);
}

/// False when there are faults.
bool printCheck(const State<2>& state, const MeshCheck& check) {
    printShapes("Fluid", state.mesh.fluid, check.fluid, state.nodes.x);
    printShapes("Solid", state.mesh.solid, check.solid, state.nodes.x);
    if (state.mesh.fluid.size() > 0)
        fmt::print("Boundary of the fluid: free surface {:.6g} m in {} pieces, walls {:.6g} m, solids {:.6g} m\n",
                   check.freeSurface, check.pieces, check.wetWalls, check.interface);
    const auto& drops = state.nodes.dropVolume;
    if (const auto n = std::count_if(drops.begin(), drops.end(), [](double volume) { return volume > 0; }); n > 0)
        fmt::print("Drops in flight: {} nodes, {:.3g} m2\n", n, std::accumulate(drops.begin(), drops.end(), 0.0));
    printFaults(check.faults, "***");
    printFaults(check.gaps, "*");
    // while a run goes on, a narrow gap is a contact to come
    const std::size_t failed = check.faults.size() + (state.time.index == 0 ? check.gaps.size() : 0);
    fmt::print("{}\n\n", failed == 0 ? "Mesh OK." : fmt::format("Failed {} mesh checks.", failed));
    return failed == 0;
}

}  // namespace

int main(int argc, char** argv) {
    OptionsSpec spec;
    spec.addTimeSelection();
    return runApplication(argc, argv, "Check the mesh of the written times.", spec, [](const Options& options) {
        const Case theCase = options.openCase();
        bool good = true;
        for (const auto& time : selectTimes(theCase, options)) {
            const State<2> state = readState<2>(theCase.time(time.name));
            const auto kinds = readProblem<2>(theCase, state).conditions.kind;
            const auto topology = makeTopology<2>(state.mesh, kinds, state.nodes.x, state.nodes.wall);
            fmt::print("Time = {}\n\n", time.name);
            good = printCheck(state, checkMesh(state.mesh, topology, state.nodes.x, state.nodes.h)) && good;
        }
        fmt::print("End\n\n");
        return good ? 0 : 1;
    });
}
