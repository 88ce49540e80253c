#pragma once
// What a run leaves in its case: time folders and, where it cannot go on, the reason.

#include "case/timeControl.hpp"
#include "io/series.hpp"
#include "solver/simulation.hpp"

namespace pfem {

/// `theCase`, `clock` and `simulation` must live longer; the latter's state is that of the folder with which the run
/// begins.
template <int Dim>
class Recorder {
public:
    Recorder(const Case& theCase, TimeControl& clock, Simulation<Dim>& simulation)
        : case_(theCase),
          clock_(clock),
          simulation_(simulation),
          series_(theCase.root()),
          first_(simulation.state.time.index),
          written_(first_),
          name_(clock.startName()) {}

    /// Write the folder of this time and the lists for ParaView; nothing when it stands there already. Throws
    /// UserError.
    void save() { save(simulation_.state); }

    /// Make the lists for ParaView whole: a run that was killed may have left its last folder out of them.
    void list() { series_.write(); }

    /// Simulation's start() and step(). Where the ledger's fields are counted, the start's folder
    /// gets them too, zeros: ParaView offers the fields of the first time. When they fail for good, the last good state
    /// is written and the folder failed/, and a StepFailure tells the reason, the place and where both are.
    void start(double dt);
    AdvanceReport step(double dt);

private:
    void save(const State<Dim>& state);
    [[noreturn]] void giveUp(const std::string& what, const StepFailure& failure, const State<Dim>& last);

    const Case& case_;
    TimeControl& clock_;
    Simulation<Dim>& simulation_;
    Series series_;     // for ParaView
    int first_;         // index of the time at which the run began
    int written_;       // index of the time that was written last
    std::string name_;  // of its folder
};

}  // namespace pfem
