#pragma once
// The continuity equation of a step: its residual (28)-(33), and the pressure that answers it (44)-(45).

#include "continuity/continuitySystem.hpp"
#include "continuity/residual.hpp"
#include "solver/anderson.hpp"
#include "solver/momentumEquation.hpp"

namespace pfem {

template <int Dim>
class ContinuityEquation {
public:
    /// With the fluid at x^n, where the matrix is made: of a share (hasOwnRows) or all of it. The references must
    /// outlive the equation.
    ContinuityEquation(const Step<Dim>& step, const Controls& controls, const FluidPhase<Dim>& fluid,
                       const MomentumEquation<Dim>& momentum);

    /// R_c of the iterate [m2/s (2D), m3/s].
    std::vector<double> residual(const Trial<Dim>& trial) const;

    /// dp for the right-hand side -R_c. The matrix is made anew in the configuration of the iterate when it is old.
    std::vector<double> solve(const std::vector<double>& residual, const Trial<Dim>& trial);

    /// The excess pressure that follows from `excess` and dp, accelerated by those before.
    std::vector<double> next(const std::vector<double>& excess, const std::vector<double>& dp) {
        return acceleration_.next(excess, dp);
    }

    /// The iteration begins anew: the fluid's domains, which have waited, move from now on.
    void restart() { acceleration_.restart(); }

private:
    /// `fluid`: with the domains that the matrix takes.
    ContinuitySystem<Dim> makeSystem(const FluidPhase<Dim>& fluid, const Points<Dim>& x) const;

    const Step<Dim>& step_;
    const Controls& controls_;
    const FluidPhase<Dim>& fluid_;
    const MomentumEquation<Dim>& momentum_;
    bool ownRows_;  // of its matrix this process makes a share alone
    Stabilisation stabilisation_;
    ContinuitySystem<Dim> system_;
    std::vector<double> viscousScale_;  // factor of mu div v in dp, per node
    Anderson acceleration_;
    int iterations_ = 0;
};

}  // namespace pfem
