#include "momentum/trial.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "momentum/rigidInertia.hpp"

namespace pfem {

namespace {

/// Positions and accelerations at the end of the step that follow from its velocities (22).
template <int Dim>
void moveEnd(const Step<Dim>& step, Nodes<Dim>& end) {
    const Problem<Dim>& problem = step.problem;
    const Topology<Dim>& topology = step.topology;
    const NodeConstraints<Dim>& constraints = step.constraints;
    const Nodes<Dim>& old = step.old;
    const MidpointRule& midpoint = step.midpoint;
    const double dt = midpoint.dt;
    parallelFor(old.size(), [&](int i) {
        if (!constraints.freedom[i].any() && !constraints.isMoved(i)) {
            if (topology.isolated(i)) end.v[i] = end.a[i] = Vec<Dim>::Zero();  // a drop on a wall that it sticks to
            return;
        }
        const Vec<Dim> fall = constraints.project(i, problem.gravity);
        if (topology.isolated(i)) {
            end.v[i] = old.v[i] + dt * fall;
            end.p[i] = 0;
        }
        end.x[i] = midpoint.template position<Dim>(old.x[i], old.v[i], end.v[i]);
        end.a[i] = topology.isolated(i) ? fall
                   : topology.wet(i)    ? midpoint.template acceleration<Dim>(old.v[i], end.v[i])
                                        : midpoint.template endAcceleration<Dim>(old.v[i], end.v[i], old.a[i]);
        if (!constraints.isMoved(i)) return;
        end.x[i] = constraints.position(i, old.x[i], end.x[i]);
        end.v[i] = constraints.velocity(i, end.x[i], end.v[i]);
        end.a[i] = constraints.combine(i, end.a[i], (end.v[i] - old.v[i]) / dt);  // no ringing after a jump
    });
}

/// Rigid bodies: all of their nodes at once.
template <int Dim>
void moveBodies(const Step<Dim>& step, Trial<Dim>& trial) {
    const auto& bodies = step.constraints.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody<Dim>& body = bodies[b];
        const Pose<Dim> pose = body.moved(trial.twist[b], step.dt());
        const Twist<Dim> twist = body.twistAt(pose, trial.twist[b]);
        for (std::size_t k = 0; k < body.nodes.size(); ++k) {
            const int i = body.nodes[k];
            trial.end.x[i] = pose.place(body.arm[k]);
            trial.end.v[i] = leverRows<Dim>(pose.lever(body.arm[k])) * twist;
            trial.end.a[i] = (trial.end.v[i] - step.old.v[i]) / step.dt();
        }
    }
}

/// What rides on solids, when these have moved.
template <int Dim>
void moveRiders(const Step<Dim>& step, Nodes<Dim>& end) {
    const auto& [constraints, old] = std::tie(step.constraints, step.old);
    if (constraints.riders.empty()) return;
    carryRiders<Dim>(constraints.riders, end.v);
    for (const auto& rider : constraints.riders) {
        const int i = rider.ride.node;
        end.x[i] += rider.carried(end.x) - rider.carried(old.x);
        end.a[i] = constraints.combine(i, end.a[i], (end.v[i] - old.v[i]) / step.dt());
    }
}

/// Positions and velocities in the middle of the step, and its acceleration.
template <int Dim>
void moveMiddle(const Step<Dim>& step, Trial<Dim>& trial) {
    const Nodes<Dim>&old = step.old, &end = trial.end;
    parallelFor(old.size(), [&](int i) {
        trial.middle.x[i] = step.midpoint.template middle<Dim>(old.x[i], end.x[i]);
        trial.middle.v[i] = step.midpoint.template middle<Dim>(old.v[i], end.v[i]);
        trial.middle.a[i] = step.midpoint.template acceleration<Dim>(old.v[i], end.v[i]);
    });
}

/// rho g, with which the pressure of a node that is moved within the iteration changes when it keeps its depth; zero in
/// steps that are short beside sqrt(h/g), where nothing moves far and a fall needs no pressure [Pa/m].
template <int Dim>
Vec<Dim> depthGradient(const Problem<Dim>& problem, const Nodes<Dim>& nodes, double dt) {
    const ViscousFluid* fluid = firstFluid(problem.materials);
    const double h = nodes.h.empty() ? 0 : *std::min_element(nodes.h.begin(), nodes.h.end());
    if (!fluid || problem.gravity.norm() * dt * dt < 0.1 * h) return Vec<Dim>::Zero();
    return fluid->rho * problem.gravity;
}

/// p + gradient . x of a wet node; others keep p.
template <int Dim>
double withDepth(const Vec<Dim>& gradient, const Topology<Dim>& topology, const Points<Dim>& x, double p, int i) {
    return topology.wet(i) ? p + gradient.dot(x[i]) : p;
}

/// The pressure of the trial from its excess.
template <int Dim>
void followDepth(const Topology<Dim>& topology, Trial<Dim>& trial) {
    parallelFor(topology.nNodes(), [&](int i) {
        trial.middle.p[i] = trial.end.p[i] = withDepth<Dim>(trial.depth, topology, trial.middle.x, trial.excess[i], i);
    });
}

}  // namespace

template <int Dim>
void setExcess(const Step<Dim>& step, const std::vector<double>& excess, Trial<Dim>& trial) {
    trial.excess = excess;
    followDepth<Dim>(step.topology, trial);
}

template <int Dim>
Trial<Dim> firstTrial(const Step<Dim>& step) {
    const Nodes<Dim>& old = step.old;
    Trial<Dim> trial;
    parallelInvoke(
        old.size(), [&] { trial.end = old; }, [&] { trial.middle = old; });
    trial.depth = depthGradient<Dim>(step.problem, old, step.dt());
    for (const auto& body : step.constraints.bodies) trial.twist.push_back(body.twist);
    moveEnd(step, trial.end);
    moveBodies(step, trial);
    moveRiders(step, trial.end);
    moveMiddle(step, trial);
    trial.excess.resize(old.p.size());
    parallelFor(old.size(),
                [&](int i) { trial.excess[i] = withDepth<Dim>(-trial.depth, step.topology, old.x, old.p[i], i); });
    followDepth<Dim>(step.topology, trial);
    return trial;
}

template <int Dim>
void changeVelocity(const Step<Dim>& step, double part, const Points<Dim>& dv, Trial<Dim>& trial) {
    for (int b = 0; b < static_cast<int>(trial.twist.size()); ++b) {
        const RigidBody<Dim>& body = step.constraints.bodies[b];
        Points<Dim> ofBody;
        for (const int i : body.nodes) ofBody.push_back(part * dv[i]);
        trial.twist[b] += nearestTwist<Dim>(middleLevers<Dim>(step, body, trial, b), ofBody);
    }
    parallelFor(trial.end.size(), [&](int i) { trial.end.v[i] += part * dv[i]; });
    moveEnd(step, trial.end);
    moveBodies(step, trial);
    moveRiders(step, trial.end);
    moveMiddle(step, trial);
    followDepth<Dim>(step.topology, trial);
}

#define PFEM_INSTANTIATE(D)                                                               \
    template Trial<D> firstTrial<D>(const Step<D>&);                                      \
    template void changeVelocity<D>(const Step<D>&, double, const Points<D>&, Trial<D>&); \
    template void setExcess<D>(const Step<D>&, const std::vector<double>&, Trial<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
