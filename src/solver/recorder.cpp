#include "solver/recorder.hpp"

#include <fmt/format.h>

#include <tuple>

#include "io/stateFiles.hpp"
#include "solver/failedFolder.hpp"
#include "solver/joinedAtSides.hpp"
#include "solver/outputFields.hpp"
#include "solver/startNumbers.hpp"

namespace pfem {

template <int Dim>
void Recorder<Dim>::save(const State<Dim>& state) {
    if (state.time.index == written_) return;
    series_.look();
    writeState(clock_.folder(state.time), state, outputFields(simulation_.problem, state));
    if (clock_.written(state.time))
        series_.write();
    else
        series_.add(clock_.name(state.time));
    written_ = state.time.index;
    name_ = clock_.name(state.time);
}

template <int Dim>
void Recorder<Dim>::giveUp(const std::string& what, const StepFailure& failure, const State<Dim>& last) {
    std::string text = what + ":\n" + failure.what() + "\n";
    try {
        save(last);
        const auto* step = dynamic_cast<const FailedStep<Dim>*>(&failure);
        text += writeFailed(case_.root(), simulation_.problem, step ? *step : FailedStep<Dim>(failure, last), last) +
                "\nThe folder failed/ shows it (ParaView: failed/failed.pvd, flag 'failed').\n"
                "The last good state is in the folder " +
                name_ + ".";
        if (last.time.index == first_)
            text += "\nIt was the first step, computed with these numbers:\n" + startNumbers(case_);
    } catch (const UserError& error) {
        text += std::string("\nNor could the state be written: ") + error.what();
    }
    throw StepFailure(text);
}

template <int Dim>
void Recorder<Dim>::start(double dt) {
    const auto& [problem, controls] = std::tie(simulation_.problem, simulation_.controls);
    const bool isPeriodic = problem.period.any();  // then the first folder has the cells that go round, too
    if (isPeriodic) simulation_.state = joinedAtSides<Dim>(problem, controls.remeshing, simulation_.state);
    const State<Dim> given = simulation_.state;
    if (isPeriodic || given.ledger.counting()) writeState(clock_.startFolder(), given, ledgerFields(given));
    try {
        simulation_.start(dt);
    } catch (const StepFailure& failure) {
        giveUp("The pressure at the start cannot be computed", failure, given);
    }
}

template <int Dim>
AdvanceReport Recorder<Dim>::step(double dt) {
    try {
        return simulation_.step(dt);
    } catch (const StepFailure& failure) {
        giveUp(fmt::format("The step after t = {} s failed with deltaT = {:.3g} s and all its halvings",
                           simulation_.state.time.value, dt),
               failure, simulation_.state);
    } catch (const std::exception&) {
        save();
        throw;
    }
}

#define PFEM_INSTANTIATE(D) template class Recorder<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
