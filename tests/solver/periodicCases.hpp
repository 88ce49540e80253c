#pragma once
// Cases with periodic sides.

#include "conditions/periodic.hpp"
#include "mesher/space/readSpaceDict.hpp"
#include "mesher/space/spaceMesher.hpp"
#include "solver/checkPeriodic.hpp"
#include "support/cases.hpp"
#include "support/cases3.hpp"

namespace pfem::test {

/// Between x = 0 and `length`; walls go on beyond.
inline TestCase periodic(double length, const std::string& mesh, const std::string& materials,
                         const std::string& conditions, const Vec<2>& gravity) {
    TestCase c = makeCase(mesh, materials, conditions, gravity);
    c.problem.period.length[0] = length;
    return c;
}

/// Oil that streams in a slippery trough, between x = 0 and 1.5, 0.45 wide and 0.3 deep.
inline TestCase3 trough(const Vec<3>& stream) {
    const auto description = readSpaceDict(
        Dictionary::parse("dimension 3; meshSize 0.15; geometry { box { type box; min (0 0 0); max (1.5 0.45 0.3); } "
                          "ground { type box; min (-1 0 0); max (3 0.45 1); } } "
                          "bodies { oil { type fluid; material oil; geometry box; } } "
                          "walls { floor { geometry ground; open (xMin xMax zMax); } }",
                          "meshDict"),
        {"oil"}, "");
    TestCase3 c;
    c.state = buildSpaceMesh(description).state;
    for (auto& v : c.state.nodes.v) v = stream;
    c.problem.materials =
        readMaterials(Dictionary::parse("oil { type newtonian; rho 1000; mu 1; kappa 1e9; }", "materials"));
    c.problem.conditions = readBoundaryConditions<3>(Dictionary::parse("floor { type slip; }", "boundaryConditions"),
                                                     c.state.mesh.patches);
    c.problem.gravity = {0, 0, -9.81};
    c.problem.period.length = {1.5, 0, 0};
    return c;
}

/// Steps of dt.
inline void run(TestCase& c, double time, double dt) {
    const double end = c.state.time.value + time;
    while (c.state.time.value < end - 0.1 * dt) c.step(std::min(dt, end - c.state.time.value));
}

/// What is said of the text of constant/periodic.
inline std::string refusalOf(const TestCase& c, const std::string& file) {
    const auto dict = Dictionary::parse(file, "periodic");
    Problem<2> problem = c.problem;
    try {
        problem.period = periodOf<2>(dict, readEntries<PeriodicEntries>(dict));
        problem.flow = heldFlowOf<2>(dict, problem.period);
        checkPeriodic<2>(dict, problem, c.state);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

}  // namespace pfem::test
