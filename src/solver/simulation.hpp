#pragma once
// A case in motion: what a step needs and what it changes, as one value.

#include <functional>

#include "remesh/delaunay.hpp"
#include "solver/attempt.hpp"

namespace pfem {

/// The time after a step of length dt from `time`.
using NextTime = std::function<TimeInfo(const TimeInfo& time, double dt)>;

/// The time plus dt, to the last bit; a run rounds it to its write times (TimeControl::advance).
TimeInfo plainNextTime(const TimeInfo& time, double dt);

template <int Dim>
struct Simulation {
    Problem<Dim> problem;
    Controls controls;
    State<Dim> state;
    NextTime nextTime = plainNextTime;
    Triangulator<Dim> triangulator = {};  // of the last step; a copy begins from nothing, which gives the same

    /// p and a at the very start of a run that agree with the forces, and v that is free of divergence; dt: of the step
    /// to come. Throws FailedStep where they cannot be found.
    void start(double dt);

    /// Advance state and time by dt or, after rejected tries, by dt/2, dt/4, ... Throws FailedStep (or another
    /// StepFailure) after maxHalvings or below deltaTMin; the state is then the last good one.
    AdvanceReport step(double dt);
};

}  // namespace pfem
