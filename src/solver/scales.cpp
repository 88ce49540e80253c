#include "solver/scales.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/convergence.hpp"
#include "state/unseenPart.hpp"

namespace pfem {

namespace {

/// Root mean square of 2 mu |d| over the cells, of the flow v at x.
template <int Dim>
double viscousStressScale(const FluidPhase<Dim>& fluid, const Points<Dim>& x, const Points<Dim>& v) {
    const SmoothingDomains<Dim>& domains = fluid.domains;
    const int n = domains.nCells();
    if (n == 0) return 0;
    const auto square = [&](const SimplexGeometry<Dim>& element, int e, double mu) {
        const Tensor<Dim> L = gradientIn<Dim>(element, domains.cell(e), v);
        return mu * mu * (L + L.transpose()).squaredNorm();
    };
    const Share& share = domains.share;
    if (share.isWhole())
        return std::sqrt(parallelSum(n, [&](int e) { return square(domains.element[e], e, fluid.mu[e]); }) / n);
    auto mu = fluid.viscosity.mu.values();  // of nodes
    share.gather(mu);
    const auto mean = [&](int e) {  // as elementMean
        double sum = mu[domains.cell(e)[0]];
        for (int k = 1; k <= Dim; ++k) sum += mu[domains.cell(e)[k]];
        return sum / (Dim + 1);
    };
    const double sum =
        share.sum(n, [&](int e) { return square(simplexGeometry<Dim>(x, domains.cell(e)), e, mean(e)); });
    return std::sqrt(sum / n);
}

/// The largest coordinate.
template <int Dim>
double farthest(const Points<Dim>& x) {
    double most = 0;
    for (const auto& point : x) most = std::max(most, point.cwiseAbs().maxCoeff());
    return most;
}

/// The largest acceleration that pressure or stress of one node alone would make in the lightest material, p/(rho h)
/// [m/s2].
template <int Dim>
double largestPush(const Step<Dim>& step) {
    const Nodes<Dim>& nodes = step.old;
    double most = 0, rho = std::numeric_limits<double>::max();
    for (int i = 0; i < nodes.size(); ++i)
        most = std::max(most,
                        std::max(std::abs(nodes.p[i]), nodes.sigma[i].template lpNorm<Eigen::Infinity>()) / nodes.h[i]);
    for (const Material& material : step.problem.materials)
        rho = std::min(rho, material.kind == MaterialKind::fluid ? material.fluid.rho : material.solid.rho);
    return most / rho;
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
    return unseenPart * (meanSize<Dim>(step.old) + 1e-3 * farthest<Dim>(step.old.x)) / step.dt();
}

template <int Dim>
double roundOffSpeed(const Step<Dim>& step) {
    const auto& solid = step.mesh.solid;
    double part = 0;  // (c dt/h)^2, of the speed of sound
    for (int e = 0; e < solid.size(); ++e) {
        const Solid& material = step.problem.solid(solid.material[e]);
        if (material.law->kinematics() != Kinematics::reference) continue;
        const double h = step.old.h[solid.nodes[e][0]],
                     stiffness = material.elastic.lambda() + 2 * material.elastic.mu();
        part = std::max(part, stiffness / material.rho * std::pow(step.dt() / h, 2));
    }
    constexpr double roundOff = 4e-16;
    return std::min(part, 1.0) * roundOff * farthest<Dim>(step.old.x) / step.dt() +
           roundOff * step.dt() * largestPush<Dim>(step);
}

template <int Dim>
double pressureScale(const Step<Dim>& step, const FluidPhase<Dim>& fluid, double tolerance) {
    const double dt = step.dt(), roundOff = 1e-14 / (dt * tolerance),
                 unseen = unseenSpeed<Dim>(step) + roundOffSpeed<Dim>(step) / tolerance;
    double rho = 0;
    const double h = meanSize<Dim>(step.old);
    for (int material : step.mesh.fluid.material) rho = std::max(rho, step.problem.fluid(material).rho);
    const double v = rms<Dim>(step.old.v);
    return rho * (step.problem.gravity.norm() * h + 1e-6 * v * v + roundOff * v * h + unseen * h / dt) +
           viscousStressScale<Dim>(fluid, step.old.x, step.old.v);
}

#define PFEM_INSTANTIATE(D)                           \
    template double meanSize<D>(const Nodes<D>&);     \
    template double unseenSpeed<D>(const Step<D>&);   \
    template double roundOffSpeed<D>(const Step<D>&); \
    template double pressureScale<D>(const Step<D>&, const FluidPhase<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
