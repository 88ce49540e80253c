#pragma once
// What a run leaves in its case: time folders and, where it cannot go on, the reason.

#include "case/timeControl.hpp"
#include "io/series.hpp"
#include "solver/advance.hpp"

namespace pfem {

/// `theCase`, `problem` and `clock` must live longer. `start`: the state in the folder that the run begins with.
template <int Dim>
class Recorder {
public:
    Recorder(const Case& theCase, const Problem<Dim>& problem, TimeControl& clock, const State<Dim>& start)
        : case_(theCase),
          problem_(problem),
          clock_(clock),
          series_(theCase.root()),
          first_(start.time.index),
          written_(first_),
          name_(clock.startName()) {}

    /// Write the folder of this time and the lists for ParaView; nothing when it stands there already. Throws
    /// UserError.
    void save(const State<Dim>& state);

    /// startConsistently() and advance(). Where the ledger's fields are counted, the start's folder
    /// gets them too, zeros: ParaView offers the fields of the first time. When they fail for good, the last good state
    /// is written and the folder failed/, and a StepFailure tells the reason, the place and where both are.
    void start(const Controls& controls, State<Dim>& state, double dt);
    AdvanceReport advance(const Controls& controls, Triangulator& triangulator, State<Dim>& state, double dt);

private:
    [[noreturn]] void giveUp(const std::string& what, const StepFailure& failure, const State<Dim>& last);

    const Case& case_;
    const Problem<Dim>& problem_;
    TimeControl& clock_;
    Series series_;     // for ParaView
    int first_;         // index of the time at which the run began
    int written_;       // index of the time that was written last
    std::string name_;  // of its folder
};

}  // namespace pfem
