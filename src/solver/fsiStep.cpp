#include "solver/fsiStep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "continuity/continuitySystem.hpp"
#include "continuity/residual.hpp"
#include "continuity/stabilisation.hpp"
#include "continuity/viscousPressure.hpp"
#include "momentum/fluidStress.hpp"
#include "momentum/momentumSystem.hpp"
#include "momentum/residual.hpp"
#include "momentum/solidStress.hpp"
#include "momentum/surfaceStiffness.hpp"
#include "momentum/wallFriction.hpp"
#include "solver/anderson.hpp"
#include "solver/convergence.hpp"
#include "solver/newtonDamping.hpp"

namespace pfem {

namespace {

/// Positions and accelerations that follow from the trial velocities (22). Isolated particles are in ballistic flight,
/// slide down their wall or stick to it. What follows a moving wall does so whatever the trial says.
template <int Dim>
void moveNodes(const Newmark& newmark, const NodeConstraints<Dim>& constraints, const Topology<Dim>& topology,
               const Vec<Dim>& gravity, const Nodes<Dim>& old, Nodes<Dim>& trial) {
    const double dt = newmark.dt;
    forEach(old.size(), [&](int i) {
        if (constraints.hold[i] == Hold::fixed && !constraints.isMoved(i)) {
            if (topology.isolated(i)) trial.v[i] = trial.a[i] = Vec<Dim>::Zero();  // a drop on a wall that it sticks to
            return;
        }
        const Vec<Dim> fall = constraints.project(i, gravity);
        if (topology.isolated(i)) {
            trial.v[i] = old.v[i] + dt * fall;
            trial.p[i] = 0;
        }
        trial.x[i] = newmark.position<Dim>(old.x[i], old.v[i], trial.v[i]);
        trial.a[i] = topology.isolated(i) ? fall
                     : topology.wet(i)    ? newmark.acceleration<Dim>(old.v[i], trial.v[i])
                                          : newmark.endAcceleration<Dim>(old.v[i], trial.v[i], old.a[i]);
        if (!constraints.isMoved(i)) return;
        trial.x[i] = constraints.position(i, old.x[i], trial.x[i]);
        trial.v[i] = constraints.velocity(i, trial.x[i], trial.v[i]);
        trial.a[i] = constraints.combine(i, trial.a[i], (trial.v[i] - old.v[i]) / dt);  // no ringing after a jump
    });
}

/// Where the forces act: positions and velocities in the middle of the step, with the step's pressure and acceleration.
template <int Dim>
void takeMiddle(const Newmark& newmark, const Nodes<Dim>& old, const Nodes<Dim>& trial, Nodes<Dim>& middle) {
    forEach(old.size(), [&](int i) {
        middle.x[i] = newmark.middle<Dim>(old.x[i], trial.x[i]);
        middle.v[i] = newmark.middle<Dim>(old.v[i], trial.v[i]);
        middle.a[i] = newmark.acceleration<Dim>(old.v[i], trial.v[i]);
        middle.p[i] = trial.p[i];
    });
}

/// rho g, with which the pressure of a node that is moved within the iteration changes when it keeps its depth; zero in
/// steps that are short beside sqrt(h/g), where nothing moves far and a fall needs no pressure [Pa/m].
template <int Dim>
Vec<Dim> depthGradient(const Problem<Dim>& problem, const Nodes<Dim>& nodes, double dt) {
    const auto fluid = std::find_if(problem.materials.begin(), problem.materials.end(),
                                    [](const Material& m) { return m.kind == MaterialKind::fluid; });
    const double h = nodes.h.empty() ? 0 : *std::min_element(nodes.h.begin(), nodes.h.end());
    if (fluid == problem.materials.end() || problem.gravity.norm() * dt * dt < 0.1 * h) return Vec<Dim>::Zero();
    return fluid->fluid.rho * problem.gravity;
}

/// p + gradient . x of the wet nodes; others keep p.
template <int Dim>
std::vector<double> withDepth(const Vec<Dim>& gradient, const Topology<Dim>& topology, const Points<Dim>& x,
                              std::vector<double> p) {
    forEach(topology.nNodes(), [&](int i) {
        if (topology.wet(i)) p[i] += gradient.dot(x[i]);
    });
    return p;
}

/// Would the motion with the old velocities leave less than a fifth of some fluid cell? So it is at an impact, before
/// the pressure has answered; residuals of cells turned inside out would only mislead the iteration. The fluid's
/// patches then wait at x^n for the first two velocities.
template <int Dim>
bool collapses(const Patches<Dim>& fluid, const Points<Dim>& x) {
    const auto collapsing = [&](int e) {
        return simplexMeasure<Dim>(x, fluid.cell(e)) < 0.2 * fluid.element[e].measure;
    };
    return firstOf(fluid.nCells(), collapsing) < fluid.nCells();
}

/// A solid element that is turned inside out, or a fluid patch without volume, cannot be accepted.
template <int Dim>
void checkPatches(const Patches<Dim>& fluid, const Patches<Dim>& solid, const Nodes<Dim>& nodes) {
    const auto place = [&](const Vec<Dim>& x) { return fmt::format("({:.6g} {:.6g})", x[0], x[1]); };
    for (int e = 0; e < solid.nCells(); ++e)
        if (!(solid.element[e].measure > 0))
            throw StepFailure("solid element inverted at " + place(simplexCentroid<Dim>(nodes.x, solid.cell(e))),
                              idsOf<Dim>(nodes, solid.cell(e)));
    for (int i = 0; i < fluid.nNodes(); ++i)
        if (fluid.around->count(i) > 0 && !(fluid.volume[i] > 0))
            throw StepFailure(fmt::format("fluid patch of node {} inverted at {}", nodes.id[i], place(nodes.x[i])),
                              {nodes.id[i]});
}

/// A step that did not converge: how far it came, and where the pressure still changes most.
template <int Dim>
StepFailure notConverged(const StepReport& report, const std::vector<double>& dp, const Nodes<Dim>& nodes,
                         const Topology<Dim>& topology, const Patches<Dim>& fluid) {
    const auto text = fmt::format("no convergence in {} iterations: |dv|/|v| = {:.3g}, |dp|/|p| = {:.3g}",
                                  report.iterations, report.finalU, report.finalP);
    const auto worst =
        std::max_element(dp.begin(), dp.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (worst == dp.end() || *worst == 0) return StepFailure(text);
    const int i = static_cast<int>(worst - dp.begin());
    double least = std::numeric_limits<double>::max();
    for (int s = topology.fluid.start[i]; s < topology.fluid.start[i + 1]; ++s)
        least = std::min(least, fluid.element[topology.fluid.cell[s]].measure);
    return StepFailure(
        text + fmt::format("; worst at ({:.6g} {:.6g}), node {} with {} triangles, smallest {:.3g} h^{}", nodes.x[i][0],
                           nodes.x[i][1], nodes.id[i], topology.fluid.count(i), least / std::pow(nodes.h[i], Dim), Dim),
        {nodes.id[i]});
}

/// Root mean square of 2 mu |d| over the cells: a pressure that is small beside the viscous stress need not be exact.
template <int Dim>
double viscousStressScale(const Patches<Dim>& fluid, const std::vector<double>& mu, const Points<Dim>& v) {
    const auto L = elementGradient<Dim>(fluid, v);
    const double sum =
        sumOver(fluid.nCells(), [&](int e) { return mu[e] * mu[e] * (L[e] + L[e].transpose()).squaredNorm(); });
    return fluid.nCells() > 0 ? std::sqrt(sum / fluid.nCells()) : 0;
}

template <int Dim>
double meanSize(const Nodes<Dim>& nodes) {
    double h = 0;
    for (double size : nodes.h) h += size / nodes.size();
    return h;
}

/// A speed that moves nothing within a step: so that where nothing moves yet no change is measured by round-off, that
/// of far places included [m/s].
template <int Dim>
double unseenSpeed(const Nodes<Dim>& nodes, double dt) {
    double farthest = 0;
    for (const auto& x : nodes.x) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
    return unseenPart * (meanSize<Dim>(nodes) + 1e-3 * farthest) / dt;
}

/// Largest density times g times the mean node distance: the pressure that one layer of fluid makes. The part of the
/// velocity keeps the round-off of a flow without gravity or pressure from counting as a change; so does `roundOff`
/// [1/s], the part of the velocities that cannot be told apart over the length of the step and the tolerance; and
/// `unseen` [m/s] is what stops within it.
template <int Dim>
double pressureScale(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const Nodes<Dim>& nodes, double roundOff,
                     double unseen, double dt) {
    double rho = 0;
    const double h = meanSize<Dim>(nodes);
    for (int material : mesh.fluid.material) rho = std::max(rho, problem.fluid(material).rho);
    const double v = rms<Dim>(nodes.v);
    return rho * (problem.gravity.norm() * h + 1e-6 * v * v + roundOff * v * h + unseen * h / dt);
}

/// Factor of mu div v in the change of pressure. A patch at the free surface, whose sides give way, resists its
/// swelling by mu/3 only (plane strain): more would overshoot.
template <int Dim>
std::vector<double> viscousPressureScale(double scale, const Topology<Dim>& topology) {
    std::vector<double> result(topology.nNodes(), scale);
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.freeSurface[i]) result[i] *= 1.0 / 3;
    return result;
}

/// Solid mass (constant) plus fluid mass in the configuration of the patches.
template <int Dim>
std::vector<double> nodalMass(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const Patches<Dim>& fluid,
                              const std::vector<double>& solid) {
    auto mass = fluidMass<Dim>(problem, mesh.fluid, fluid);
    forEach(static_cast<int>(mass.size()), [&](int i) { mass[i] += solid[i]; });
    return mass;
}

/// The step. `trial`: state n on entry; what was reached when it throws.
template <int Dim>
StepResult<Dim> iterate(const Problem<Dim>& problem, const Controls& controls, const Mesh<Dim>& mesh,
                        const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, const Nodes<Dim>& old,
                        double dt, double divTarget, Nodes<Dim>& trial) {
    const Newmark newmark{dt, controls.timeIntegration.gamma};

    // the matrices, at x^n, once per step
    const Integration scheme = controls.integration.scheme();
    Patches<Dim> fluid = makePatches<Dim>(mesh.fluid.nodes, topology.fluid, old.x, scheme);
    Patches<Dim> solid = makePatches<Dim>(mesh.solid.nodes, topology.solid, old.x, scheme);
    Patches<Dim> solidGradients = solid;  // at the positions that the stress update asks for
    const auto massOfSolid = solidMass<Dim>(problem, mesh.solid, old.X);
    auto mass = nodalMass<Dim>(problem, mesh, fluid, massOfSolid);
    auto dofs = solidDofs<Dim>(topology.solid, constraints);
    const auto stiffness = surfaceStiffness<Dim>(problem, mesh.fluid, topology, old.x, newmark);
    const auto inertia = matrixInertia<Dim>(mass, stiffness, newmark);
    auto solidA = solidMatrix<Dim>(problem, controls.solid, mesh.solid, solid, dofs, inertia, old.h, newmark);
    auto viscosity = flowViscosity<Dim>(problem, mesh.fluid, fluid, old.v);
    MomentumSystem<Dim> momentum(problem, controls.momentum, mesh, topology, constraints, fluid, viscosity, inertia,
                                 std::move(dofs), std::move(solidA), newmark);
    auto cellMu = fromPoints<Dim>(fluid, viscosity.mu);
    const Stabilisation held{stabilisation<Dim>(problem, mesh.fluid, fluid, cellMu, old.v, dt),
                             projectedCells<Dim>(controls.continuity, problem, mesh.fluid, topology, old)};
    ContinuitySystem<Dim> continuity(problem, controls.continuity, mesh.fluid, topology, constraints, fluid, cellMu,
                                     held, old.x, momentum.solidDofs(), momentum.solidMatrix(), newmark);

    const double waveDamping =
        2 * controls.momentum.waveDamping * dt * std::sqrt(problem.gravity.norm() / meanSize<Dim>(old));
    const double unseen = unseenSpeed<Dim>(old, dt);
    Convergence convergence(
        controls.convergence, unseen,
        pressureScale<Dim>(problem, mesh, old, 1e-14 / (dt * controls.convergence.tolP), unseen, dt) +
            viscousStressScale<Dim>(fluid, cellMu, old.v));
    StepReport report;
    std::vector<double> dp;
    SolidStress<Dim> stressOfSolid;
    Points<Dim> viscous;
    const bool yields = !isNewtonian<Dim>(problem);
    const auto viscousScale = viscousPressureScale<Dim>(controls.continuity.viscousScale, topology);
    NewtonDamping<Dim> damping;
    Anderson pressureIteration(controls.convergence.accelerationDepth);
    Points<Dim> solidForceOld(old.size(), Vec<Dim>::Zero());
    addInternalForce<Dim>(solid, storedElementStress<Dim>(problem, controls.solid, mesh.solid, solid, old),
                          solidForceOld);
    moveNodes<Dim>(newmark, constraints, topology, problem.gravity, old, trial);
    Nodes<Dim> middle = old;
    // the iteration changes p - rho g . x: nodes that move take the pressure of their depth along
    const Vec<Dim> depth = depthGradient<Dim>(problem, old, dt);
    std::vector<double> excess = withDepth<Dim>(-depth, topology, old.x, old.p);
    takeMiddle<Dim>(newmark, old, trial, middle);
    middle.p = trial.p = withDepth<Dim>(depth, topology, middle.x, excess);
    const int waiting = collapses<Dim>(fluid, trial.x) ? 2 : 0;
    if (waiting == 0) updatePatches<Dim>(fluid, middle.x);
    for (bool converged = false; !converged;) {
        if (report.iterations == controls.convergence.maxIterations)
            throw notConverged<Dim>(report, dp, trial, topology, fluid);
        // patches (those of the fluid are there), stresses, momentum residual, velocities
        updatePatches<Dim>(solid, trial.x);
        updatePatches<Dim>(solidGradients, gradientPositions<Dim>(controls.solid, old, trial));
        mass = nodalMass<Dim>(problem, mesh, fluid, massOfSolid);
        stressOfSolid = solidStress<Dim>(problem, controls.solid, mesh.solid, solidGradients, old, trial, dt);
        if (yields) {
            viscosity = flowViscosity<Dim>(problem, mesh.fluid, fluid, middle.v);
            cellMu = fromPoints<Dim>(fluid, viscosity.mu);
            momentum.setViscosity(viscosity);
        }
        // a viscous force that can hardly change any more stays as it is
        if (report.iterations == 0 ||
            std::max(momentum.viscousNumber(), waveDamping) * report.finalU > 0.1 * controls.convergence.tolU) {
            viscous = viscousForce<Dim>(fluid, viscosity.mu, middle.v);
            const auto zigzag =
                zigzagForce<Dim>(problem, mesh.fluid, fluid, controls.momentum.waveDamping, old.h, middle.v);
            forEach(trial.size(), [&](int i) { viscous[i] += zigzag[i]; });
        }
        auto external = tractionForce<Dim>(mesh, problem.conditions, middle.x);
        addWallFriction<Dim>(problem, mesh.fluid, topology, middle, external);
        addSideFriction<Dim>(problem, mesh.fluid, fluid, middle.v, external);
        forEach(trial.size(), [&](int i) { external[i] -= viscous[i] + (1 - newmark.gamma) * solidForceOld[i]; });
        auto elementStress =
            solidElementStress<Dim>(problem, controls.solid, mesh.solid, solidGradients, solid, stressOfSolid, trial);
        for (auto& sigma : elementStress) sigma *= newmark.gamma;
        auto R_m =
            momentumResidual<Dim>(mass, middle.a, problem.gravity, fluid, middle.p, solid, elementStress, external);
        forEach(trial.size(), [&](int i) { R_m[i] /= newmark.gamma; });
        momentum.setInertia(matrixInertia<Dim>(mass, stiffness, newmark));
        const auto dv = momentum.solve(R_m);
        const double part = yields ? damping.next(dv) : 1;
        forEach(trial.size(), [&](int i) { trial.v[i] += part * dv[i]; });
        moveNodes<Dim>(newmark, constraints, topology, problem.gravity, old, trial);

        takeMiddle<Dim>(newmark, old, trial, middle);
        middle.p = trial.p = withDepth<Dim>(depth, topology, middle.x, excess);

        // patches again: the continuity lives in the updated configuration, and so does the next momentum
        updatePatches<Dim>(fluid, report.iterations + 1 < waiting ? old.x : middle.x);
        const auto R_c = continuityResidual<Dim>(problem, controls.continuity, mesh.fluid, topology, fluid, cellMu,
                                                 held, trial, middle, old, dt, divTarget);
        if (report.iterations > 0 && report.iterations % controls.convergence.refactorEvery == 0) {
            pressureIteration.restart();
            continuity =
                ContinuitySystem<Dim>(problem, controls.continuity, mesh.fluid, topology, constraints, fluid, cellMu,
                                      held, middle.x, momentum.solidDofs(), momentum.solidMatrix(), newmark);
        }
        if (report.iterations == waiting) pressureIteration.restart();
        dp = continuity.solve(R_c);
        if (momentum.isViscous())
            addViscousPressure<Dim>(fluid, yields ? fromPoints<Dim>(fluid, tangentViscosity<Dim>(viscosity)) : cellMu,
                                    viscousScale, R_c, dp);
        excess = pressureIteration.next(excess, dp);
        middle.p = trial.p = withDepth<Dim>(depth, topology, middle.x, excess);

        converged =
            convergence.reached(rms<Dim>(dv), rms<Dim>(trial.v), rms(dp), rms(trial.p)) && report.iterations >= waiting;
        const int linear = report.linearIterations + momentum.linearIterations();
        report = convergence.report();
        report.linearIterations = linear;
    }
    updatePatches<Dim>(solid, trial.x);
    updatePatches<Dim>(fluid, trial.x);
    checkPatches<Dim>(fluid, solid, trial);
    StepResult<Dim> result{std::move(trial), {}, report};
    storeSolidStress<Dim>(solid, std::move(stressOfSolid), result.nodes.sigma, result.cellSigma);
    return result;
}

}  // namespace

template <int Dim>
StepResult<Dim> fsiStep(const Problem<Dim>& problem, const Controls& controls, const Mesh<Dim>& mesh,
                        const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, const Nodes<Dim>& old,
                        double dt, double divTarget) {
    Nodes<Dim> trial = old;
    try {
        return iterate<Dim>(problem, controls, mesh, topology, constraints, old, dt, divTarget, trial);
    } catch (const StepFailure& failure) {
        throw FailedStep<Dim>(failure, std::move(trial), mesh);
    }
}

template <int Dim>
Nodes<Dim> consistentStart(Problem<Dim> problem, Controls controls, const Mesh<Dim>& mesh,
                           const Topology<Dim>& topology, const ConstraintsOver<Dim>& constraintsOver,
                           const Nodes<Dim>& nodes, double moment) {
    // a fluid without free surface has its pressure up to a constant: a trace of compressibility says which
    const bool open =
        std::find(topology.freeSurface.begin(), topology.freeSurface.end(), 1) != topology.freeSurface.end();
    double h = 0;
    for (double size : nodes.h) h = std::max(h, size);
    for (auto& material : problem.materials)
        material.fluid.kappa = open ? 1e300 : 1e8 * material.fluid.rho * h * h / (moment * moment);
    const Controls asGiven = controls;
    const double firstStep = 1e3 * moment;
    controls.timeIntegration.gamma = 1;
    controls.convergence.tolU = 1e-11;
    controls.convergence.tolP = open ? 1e-11 : 1e-6;
    controls.convergence.maxIterations = 300;
    double t = 0;  // walls that accelerate go on doing so
    const auto step = [&](const Nodes<Dim>& from) {
        const auto constraints = constraintsOver(t, t + moment);
        t += moment;
        return fsiStep<Dim>(problem, controls, mesh, topology, constraints, from, moment, 0).nodes;
    };
    Nodes<Dim> start = nodes;
    // Impulses until no more changes v: each leaves the part that the stabilisation forgives. Steady forces change it
    // by the same in each moment; that is taken off again.
    int impulses = 0;
    double last = std::numeric_limits<double>::max();
    Nodes<Dim> next = step(start);
    while (impulses < 50 && rms<Dim>(nodes.v) > 0) {
        const double change = moment * rms<Dim>(next.a);
        if (change < 5e-4 * rms<Dim>(next.v) || change > 0.99 * last) break;
        last = change;
        start.v = next.v;
        ++impulses;
        next = step(start);
    }
    if (impulses == 0) {
        start.p = next.p;
        start.a = next.a;
        return start;
    }
    for (int i = 0; i < start.size(); ++i) start.v[i] -= impulses * moment * next.a[i];
    // what is left of the impulses is no pressure: that of a first step of usual length is
    const Nodes<Dim> first =
        fsiStep<Dim>(problem, asGiven, mesh, topology, constraintsOver(0, firstStep), start, firstStep, 0).nodes;
    start.p = first.p;
    start.a = first.a;
    return start;
}

#define PFEM_INSTANTIATE(D)                                                                                   \
    template StepResult<D> fsiStep<D>(const Problem<D>&, const Controls&, const Mesh<D>&, const Topology<D>&, \
                                      const NodeConstraints<D>&, const Nodes<D>&, double, double);            \
    template Nodes<D> consistentStart<D>(Problem<D>, Controls, const Mesh<D>&, const Topology<D>&,            \
                                         const ConstraintsOver<D>&, const Nodes<D>&, double);
PFEM_INSTANTIATE(2)

}  // namespace pfem
