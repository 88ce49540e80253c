#include "case/controlDict.hpp"
#include "reference/keywords.hpp"
#include "solver/controls.hpp"

namespace pfem {

std::vector<KeywordTable> systemKeywords() {
    const std::string solution = "system/pfemSolution";
    return {
        {"system/controlDict", "", "Times, time step, output. `functions`: see the next sections.",
         describeEntries<ControlDict>()},
        {solution, "", "The numbers of the algorithm; the file may be left out.",
         describeEntries<IntegrationControls>()},
        {solution, "timeIntegration", "Time integration.", describeEntries<TimeIntegrationControls>()},
        {solution, "convergence", "The nonlinear iteration of a step, and what becomes of steps that fail.",
         describeEntries<ConvergenceControls>()},
        {solution, "momentum", "The momentum equation's linear system.", describeEntries<MomentumControls>()},
        {solution, "continuity", "The stabilised continuity equation.", describeEntries<ContinuityControls>()},
        {solution, "solid", "Elastic solids.", describeEntries<SolidControls>()},
        {solution, "remeshing", "Joining the fluid's nodes to triangles after each step.",
         describeEntries<RemeshingControls>()},
        {solution, "remeshing/expert", "What hardly changes results.", describeEntries<ExpertRemeshing>()},
    };
}

}  // namespace pfem
