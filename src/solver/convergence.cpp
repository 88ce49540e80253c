#include "solver/convergence.hpp"

#include <algorithm>
#include <cmath>

namespace pfem {

bool Convergence::reached(double dv, double v, double dp, double p) {
    if (!std::isfinite(dv) || !std::isfinite(dp)) throw StepFailure("velocity or pressure is not finite");
    if (report_.iterations == 0) {
        velocityScale_ = std::max({velocityScale_, v, 1e-300});
        pressureScale_ = std::max({pressureScale_, p, 1e-300});
        report_.initialU = dv / velocityScale_;
        report_.initialP = dp / pressureScale_;
    }
    ++report_.iterations;
    report_.finalU = dv / velocityScale_;
    report_.finalP = dp / pressureScale_;
    return report_.iterations >= controls_.minIterations && report_.finalU < controls_.tolU &&
           report_.finalP < controls_.tolP;
}

}  // namespace pfem
