#include "solver/scales.hpp"

#include <algorithm>
#include <cmath>

#include "solver/convergence.hpp"
#include "state/unseenPart.hpp"

namespace pfem {

namespace {

/// Root mean square of 2 mu |d| over the cells.
template <int Dim>
double viscousStressScale(const FluidPhase<Dim>& fluid, const Points<Dim>& v) {
    const auto L = elementGradient<Dim>(fluid.domains, v);
    const int n = fluid.domains.nCells();
    const double sum =
        parallelSum(n, [&](int e) { return fluid.mu[e] * fluid.mu[e] * (L[e] + L[e].transpose()).squaredNorm(); });
    return n > 0 ? std::sqrt(sum / n) : 0;
}

}  // namespace

template <int Dim>
double meanSize(const Nodes<Dim>& nodes) {
    double h = 0;
    for (double size : nodes.h) h += size / nodes.size();
    return h;
}

template <int Dim>
double unseenSpeed(const Step<Dim>& step) {
    double farthest = 0;
    for (const auto& x : step.old.x) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
    return unseenPart * (meanSize<Dim>(step.old) + 1e-3 * farthest) / step.dt();
}

template <int Dim>
double pressureScale(const Step<Dim>& step, const FluidPhase<Dim>& fluid, double tolerance) {
    const double dt = step.dt(), roundOff = 1e-14 / (dt * tolerance), unseen = unseenSpeed<Dim>(step);
    double rho = 0;
    const double h = meanSize<Dim>(step.old);
    for (int material : step.mesh.fluid.material) rho = std::max(rho, step.problem.fluid(material).rho);
    const double v = rms<Dim>(step.old.v);
    return rho * (step.problem.gravity.norm() * h + 1e-6 * v * v + roundOff * v * h + unseen * h / dt) +
           viscousStressScale<Dim>(fluid, step.old.v);
}

#define PFEM_INSTANTIATE(D)                         \
    template double meanSize<D>(const Nodes<D>&);   \
    template double unseenSpeed<D>(const Step<D>&); \
    template double pressureScale<D>(const Step<D>&, const FluidPhase<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
