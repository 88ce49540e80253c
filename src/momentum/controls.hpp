#pragma once
// What a user may set of the momentum equation and its time integration, in system/pfemSolution.

#include <string>

#include "dictionary/entries.hpp"
#include "integration/smoothingDomains.hpp"

namespace pfem {

inline Integration schemeNamed(const std::string& word) {
    return word == "nodal" ? Integration::nodal : Integration::elemental;
}

/// At the top of system/pfemSolution.
struct IntegrationControls {
    std::string integration = "nodal";

    Integration scheme() const { return schemeNamed(integration); }

    template <class Visitor>
    void entries(Visitor& v) {
        v("integration", integration, "-",
          "where fluids and solids have their stress: nodal (in domains of nodes; solids rather too soft) or elemental "
          "(in "
          "triangles; solids rather too stiff). For solids `solid` may say another",
          oneOf({"nodal", "elemental"}));
    }
};

/// Sub-dictionary `timeIntegration`.
struct TimeIntegrationControls {
    double gamma = 0.5;

    template <class Visitor>
    void entries(Visitor& v) {
        v("gamma", gamma, "-",
          "where in the step the forces act: 0.5 its middle (second order, no damping), 1 its end (backward Euler)",
          between(0.5, 1.0));
    }
};

/// The fluid's mass in the momentum equation and in its kinetic energy.
enum class FluidMass { lumped, consistent };

/// Sub-dictionary `momentum`.
struct MomentumControls {
    std::string mass = "lumped";
    double theta = 0;
    std::string bulkRule = "local";
    double viscousLimit = 0.01;
    double waveDamping = 0.01;
    double linearTolerance = 1e-6;
    int maxLinearIterations = 500;

    FluidMass fluidMass() const { return mass == "lumped" ? FluidMass::lumped : FluidMass::consistent; }

    template <class Visitor>
    void entries(Visitor& v) {
        v("mass", mass, "-",
          "of the fluid: lumped at the nodes; consistent with velocities that are linear between them: surface waves "
          "of "
          "ten triangles' length have their period within 0.3 % instead of 3 %, for conjugate gradients in each "
          "iteration",
          oneOf({"lumped", "consistent"}));
        v("theta", theta, "-",
          "factor of the bulk term of the fluid in the momentum MATRIX (preconditioner only; the paper: 1)",
          nonNegative);
        v("bulkRule", bulkRule, "-",
          "local: rho h^2/dt of each patch; matrixMeans: one value that makes the bulk term's mean diagonal that of "
          "the "
          "mass",
          oneOf({"local", "matrixMeans"}));
        v("viscousLimit", viscousLimit, "-",
          "ratio of viscous forces to inertia (2 mu dt/(rho h^2)) that is left out of the momentum MATRIX; light "
          "nodes, a thousandth of "
          "the mass, may have thirty times that and get the diagonal",
          nonNegative);
        v("waveDamping", waveDamping, "-",
          "viscosity in units of rho h sqrt(g h) that acts on velocities of the fluid which alternate from node to "
          "node: damps waves of a few "
          "triangles' length and no longer ones; 0 = none",
          nonNegative);
        v("linearTolerance", linearTolerance, "-", "relative residual of the conjugate gradients", positive);
        v("maxLinearIterations", maxLinearIterations, "-", "limit of the conjugate gradients", atLeast(1));
    }
};

/// Sub-dictionary `solid`.
struct SolidControls {
    std::string formulation = "velocity";
    double damping = 0.1;
    std::string stressUpdate = "rotatedMidpoint";  // read for old cases: see solver/formerEntries.hpp
    std::string integration = "asFluid";

    bool withPressure() const { return formulation == "velocityPressure"; }

    /// Of solids, where fluids have `ofFluid`.
    Integration scheme(Integration ofFluid) const {
        return integration == "asFluid" ? ofFluid : schemeNamed(integration);
    }

    template <class Visitor>
    void entries(Visitor& v) {
        v("formulation", formulation, "-",
          "velocity; velocityPressure: the pressure is a field of the nodes and only the rest of the stress is "
          "integrated as "
          "`integration` says (elemental: no locking up to nu -> 0.5)",
          oneOf({"velocity", "velocityPressure"}));
        v("stressUpdate", stressUpdate, "-",
          "former place of the law, which stands in constant/materials: paper is type hypoelasticPaper there, "
          "neoHookean type neoHookean; still understood, with a warning",
          oneOf({"rotatedMidpoint", "paper", "neoHookean"}));
        v("integration", integration, "-",
          "where solids have their stress: asFluid (as `integration` above says), nodal or elemental",
          oneOf({"asFluid", "nodal", "elemental"}));
        v("damping", damping, "-", "alpha of the zig-zag damper, tau_s = alpha h sqrt(rho/E)", nonNegative);
    }
};

}  // namespace pfem
