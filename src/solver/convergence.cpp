#include "solver/convergence.hpp"

#include <algorithm>
#include <cmath>

namespace pfem {

namespace {

/// Nothing that does not change is far from its end, whatever the scale (without fluid there is no pressure).
double relative(double change, double scale) { return change == 0 ? 0 : change / scale; }

}  // namespace

bool Convergence::reached(double dv, double v, double dp, double p) {
    if (!std::isfinite(dv) || !std::isfinite(dp)) throw StepFailure("velocity or pressure is not finite");
    if (report_.iterations == 0) {
        velocityScale_ = std::max(velocityScale_, v);
        pressureScale_ = std::max(pressureScale_, p);
        report_.initialU = relative(dv, velocityScale_);
        report_.initialP = relative(dp, pressureScale_);
    }
    ++report_.iterations;
    report_.finalU = relative(dv, velocityScale_);
    report_.finalP = relative(dp, pressureScale_);
    return report_.iterations >= controls_.minIterations && report_.finalU < controls_.tolU &&
           report_.finalP < controls_.tolP;
}

}  // namespace pfem
