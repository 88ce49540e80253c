#pragma once
// Cases with periodic sides.

#include "conditions/periodic.hpp"
#include "solver/checkPeriodic.hpp"
#include "support/cases.hpp"

namespace pfem::test {

/// Between x = 0 and `length`; walls go on beyond.
inline TestCase periodic(double length, const std::string& mesh, const std::string& materials,
                         const std::string& conditions, const Vec<2>& gravity) {
    TestCase c = makeCase(mesh, materials, conditions, gravity);
    c.problem.period.length[0] = length;
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
