#pragma once
// The lines of the solver's log, in OpenFOAM's sentences so that foamLog and the like read them.

#include <string>
#include <vector>

#include "solver/attempt.hpp"
#include "solver/courantRate.hpp"

namespace pfem {

/// "Courant Number mean: ... max: ..." and "deltaT = ...".
std::string courantLines(const CourantRate& rate, double dt);

/// The solves, remeshing and, where there is fluid, the volume of one step.
template <int Dim>
std::string stepLines(const AdvanceReport& report, const State<Dim>& state, double firstVolume);

/// What the whole run did: steps, rejected tries, iterations, wall time by phase.
class RunSummary {
public:
    /// `cells`: of the fluid and the solids after the step.
    void add(const AdvanceReport& report, int cells);
    /// `clock`: wall time of the run [s]; what is neither step nor remeshing is output. `dim` tells what cells are.
    std::string text(double clock, int dim) const;

private:
    std::vector<int> iterations_;
    int rejected_ = 0;
    double cells_ = 0;                 // sum over all steps
    double step_ = 0, remeshing_ = 0;  // [s]
};

/// "ExecutionTime = 1.2 s  ClockTime = 1 s" and "Progress = 12 %  estimated time left = 34 s".
std::string timeLines(double cpu, double clock, double fraction);

}  // namespace pfem
