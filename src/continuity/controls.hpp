#pragma once
// What a user may set of the stabilised continuity equation, in system/pfemSolution.

#include <string>

#include "dictionary/entries.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

/// Sub-dictionary `continuity`.
struct ContinuityControls {
    double schurScale = 0.15;
    double viscousScale = 1;
    double complianceScale = 1;
    double freeSurfaceScale = 1;
    double freeSurfaceWeight = 1;
    std::string freeSurfacePressure = "weak";
    std::string factorPrecision = "single";
    std::string solver = "auto";
    double solverTolerance = 1e-2;
    std::string stabilisation = "projection";
    bool interfaceAcceleration = true;
    double volumeReturnTime = 0.02;
    double volumeCorrectionTime = 0;
    Ranks ranks;  // that share the multigrid; by the command line (-parallel), no entry

    template <class Visitor>
    void entries(Visitor& v) {
        v("schurScale", schurScale, "-", "factor of the Schur term dt/rho L in the pressure matrix", nonNegative);
        v("viscousScale", viscousScale, "-",
          "factor of mu div v in the change of pressure, where viscosity is in the momentum matrix (viscousLimit); a "
          "third of it at the free surface",
          nonNegative);
        v("complianceScale", complianceScale, "-",
          "factor of the elastic interface's compliance B A_s^-1 B^T in the pressure matrix", nonNegative);
        v("freeSurfaceScale", freeSurfaceScale, "-",
          "factor of the free surface's compliance B m^-1 B^T in the pressure matrix; twice as much where viscosity "
          "is in the momentum matrix (viscousLimit)",
          nonNegative);
        v("freeSurfaceWeight", freeSurfaceWeight, "-", "factor of tau_n M_G in the pressure matrix", positive);
        v("freeSurfacePressure", freeSurfacePressure, "-", "how p = 0 is imposed at the free surface",
          oneOf({"weak", "strong"}));
        v("factorPrecision", factorPrecision, "-",
          "in which the factor of the pressure matrix is kept; single takes less time, the iteration corrects what it "
          "lacks",
          oneOf({"single", "double"}));
        v("solver", solver, "-",
          "of the pressure matrix: a direct factor, multigrid (conjugate gradients with PETSc's smoothed aggregation), "
          "or "
          "auto: multigrid in three dimensions for more than 20000 pressures or 1000 elastic velocities",
          oneOf({"auto", "direct", "multigrid"}));
        v("solverTolerance", solverTolerance, "-", "of multigrid: what is left of the residual", positive);
        v("stabilisation", stabilisation, "-",
          "projection: grad p less its projection to the nodes, so that no wave near rest grows; inertia: the full "
          "residual "
          "grad p - rho (g - dv/dt), with which short waves grow; bodyForce: grad p - rho g with accelerations on "
          "faces (the paper)",
          oneOf({"projection", "inertia", "bodyForce"}));
        v("interfaceAcceleration", interfaceAcceleration, "-",
          "with bodyForce: moving solids and walls enter the stabilisation with their normal acceleration", any);
        v("volumeReturnTime", volumeReturnTime, "s",
          "time scale of a local correction: what the surface's shift (remeshing) has not returned comes back through "
          "the "
          "continuity equation, in no less than four steps; 0 = none",
          nonNegative);
        v("volumeCorrectionTime", volumeCorrectionTime, "s",
          "time scale of a correction that returns the whole fluid's volume by a uniform divergence; 0 = none",
          nonNegative);
    }
};

}  // namespace pfem
