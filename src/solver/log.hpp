#pragma once
// The lines of the solver's log, in OpenFOAM's sentences so that foamLog and the like read them.

#include <string>

#include "solver/advance.hpp"

namespace pfem {

/// "Courant Number mean: ... max: ..." and "deltaT = ...".
std::string courantLines(double mean, double max, double dt);

/// The solves, remeshing and, where there is fluid, the volume of one step.
template <int Dim>
std::string stepLines(const AdvanceReport& report, const State<Dim>& state, double firstVolume);

/// "ExecutionTime = 1.2 s  ClockTime = 1 s" and "Progress = 12 %  estimated time left = 34 s".
std::string timeLines(double cpu, double clock, double fraction);

}  // namespace pfem
