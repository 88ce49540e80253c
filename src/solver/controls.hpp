#pragma once
// All that a user may set of the algorithm: system/pfemSolution; the defaults are documented at each entry.

#include "continuity/controls.hpp"
#include "momentum/controls.hpp"
#include "remesh/controls.hpp"

namespace pfem {

/// Sub-dictionary `convergence` of the nonlinear iteration.
struct ConvergenceControls {
    double tolU = 1e-4;
    double tolP = 1e-4;
    int minIterations = 2;
    int maxIterations = 30;
    int refactorEvery = 8;
    int accelerationDepth = 2;
    int maxHalvings = 8;
    double deltaTMin = 1e-9;
    double maxVolumeChange = 0.1;

    template <class Visitor>
    void entries(Visitor& v) {
        v("tolU", tolU, "-", "relative change of velocity at which the iteration stops", positive);
        v("tolP", tolP, "-", "relative change of pressure at which the iteration stops", positive);
        v("minIterations", minIterations, "-", "iterations that every step makes at least", atLeast(1));
        v("maxIterations", maxIterations, "-", "iterations after which the step is rejected", atLeast(1));
        v("refactorEvery", refactorEvery, "-",
          "iterations after which the pressure matrix is made anew in the current configuration", atLeast(1));
        v("accelerationDepth", accelerationDepth, "-",
          "iterations that Anderson's acceleration of the pressure remembers; 0 = none", atLeast(0));
        v("maxHalvings", maxHalvings, "-", "halvings of one step before the run stops", atLeast(0));
        v("deltaTMin", deltaTMin, "s",
          "smallest step before the run stops; also when a node would cross its mesh size within it", positive);
        v("maxVolumeChange", maxVolumeChange, "-",
          "change of the fluid's volume within one step, in parts of it, at which the step is rejected", positive);
    }
};

/// All of system/pfemSolution.
struct Controls {
    IntegrationControls integration;
    TimeIntegrationControls timeIntegration;
    ConvergenceControls convergence;
    MomentumControls momentum;
    ContinuityControls continuity;
    SolidControls solid;
    RemeshingControls remeshing;

    Integration fluidScheme() const { return integration.scheme(); }
    Integration solidScheme() const { return solid.scheme(integration.scheme()); }
};

}  // namespace pfem
