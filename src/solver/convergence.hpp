#pragma once
// When the nonlinear iteration stops.

#include <cmath>

#include "base/parallel.hpp"
#include "solver/fsiStep.hpp"

namespace pfem {

/// Relative changes |dv|/|v| and |dp|/|p| with norms frozen after the first iteration; guarded against zero by
/// a speed that moves nothing within the step, and rho g h.
class Convergence {
public:
    Convergence(const ConvergenceControls& controls, double velocityScale, double pressureScale)
        : controls_(controls), velocityScale_(velocityScale), pressureScale_(pressureScale) {}

    /// Enter iteration k (from 1) with the norms (root mean squares) of changes and values.
    /// Throws StepFailure when a norm is not finite.
    bool reached(double dv, double v, double dp, double p);

    const StepReport& report() const { return report_; }

private:
    ConvergenceControls controls_;
    double velocityScale_;
    double pressureScale_;
    StepReport report_;
};

/// Root mean square over the entries.
template <int Dim>
double rms(const Points<Dim>& u) {
    const double sum = parallelSum(static_cast<int>(u.size()), [&](int i) { return u[i].squaredNorm(); });
    return u.empty() ? 0 : std::sqrt(sum / static_cast<double>(u.size()));
}

inline double rms(const std::vector<double>& u) {
    const double sum = parallelSum(static_cast<int>(u.size()), [&](int i) { return u[i] * u[i]; });
    return u.empty() ? 0 : std::sqrt(sum / static_cast<double>(u.size()));
}

}  // namespace pfem
