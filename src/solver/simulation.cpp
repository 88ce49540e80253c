#include "solver/simulation.hpp"

#include "conditions/sides.hpp"
#include "solver/beginStep.hpp"
#include "solver/consistentStart.hpp"
#include "solver/invariants.hpp"
#include "solver/joinedAtSides.hpp"
#include "walls/openings.hpp"

namespace pfem {

TimeInfo plainNextTime(const TimeInfo& time, double dt) { return {time.value + dt, time.index + 1, dt, dt}; }

template <int Dim>
void Simulation<Dim>::start(double dt) {
    const auto& conditions = problem.conditions;
    if (conditions.anyInlet())
        holdAtLips<Dim>(conditions, makeTopology<Dim>(state.mesh, conditions.kind, state.nodes.x, state.nodes.wall),
                        state.nodes);
    if (problem.period.any())
        state = unfolded<Dim>(sidesOf<Dim>(problem, state), joinedAtSides<Dim>(problem, controls.remeshing, state));
    const auto topology = beginStep<Dim>(problem, 0, state, controls.continuity.ranks).topology;
    const auto sides = sidesOf<Dim>(problem, state);
    keepImages<Dim>(sides, state);
    const auto over = [&](double from, double to) { return constraintsOver<Dim>(from, to, problem, state, topology); };
    state.nodes =
        consistentStart<Dim>(problemAt<Dim>(state.time.value, problem), controls, state, topology, over, 1e-3 * dt);
    keepImages<Dim>(sides, state);
    state = folded<Dim>(std::move(state));
}

template <int Dim>
AdvanceReport Simulation<Dim>::step(double dt) {
    AdvanceReport report;
    const auto& limits = controls.convergence;
    checkSpeed<Dim>(limits, state.nodes);
    for (report.dt = dt;; report.dt *= 0.5) {
        try {
            State<Dim> next = attempt<Dim>(problem, controls, triangulator, state, report);
            next.time = nextTime(state.time, report.dt);
            state = std::move(next);
            return report;
        } catch (const StepFailure& failure) {  // the state stays as it was
            ++report.rejected;
            report.reasons.emplace_back(failure.what());
            if (report.rejected > limits.maxHalvings || 0.5 * report.dt < limits.deltaTMin) throw;
        }
    }
}

#define PFEM_INSTANTIATE(D) template struct Simulation<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
