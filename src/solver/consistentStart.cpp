#include "solver/consistentStart.hpp"

#include <algorithm>
#include <limits>

#include "solver/convergence.hpp"

namespace pfem {

template <int Dim>
Nodes<Dim> consistentStart(Problem<Dim> problem, const Controls& asGiven, const State<Dim>& state,
                           const Topology<Dim>& topology, const ConstraintsOver<Dim>& constraintsOver, double moment) {
    const Nodes<Dim>& nodes = state.nodes;
    const auto images = imagesOf<Dim>(state);
    // a fluid without free surface has its pressure up to a constant: a trace of compressibility says which
    const auto free = images.counted(topology.freeSurface);
    const bool open = problem.conditions.anyOutlet() || std::find(free.begin(), free.end(), 1) != free.end();
    double h = 0;
    for (double size : nodes.h) h = std::max(h, size);
    for (auto& material : problem.materials)
        material.fluid.kappa = open ? 1e300 : 1e8 * material.fluid.rho * h * h / (moment * moment);
    problem.flow = nullptr;  // the flow at the start is what the case says
    Controls controls = asGiven;
    const double firstStep = 1e3 * moment;
    controls.timeIntegration.gamma = 1;
    controls.convergence.tolU = 1e-11;
    controls.convergence.tolP = open ? 1e-11 : 1e-6;
    controls.convergence.maxIterations = 300;
    double t = 0;  // walls that accelerate go on doing so
    const auto over = [&](const Controls& with, const NodeConstraints<Dim>& constraints, const Nodes<Dim>& from,
                          double dt) {
        const auto contacts = contactPairs<Dim>(problem, state.mesh, topology, from, dt);
        const Step<Dim> step{problem,  state.mesh,
                             topology, constraints,
                             from,     {dt, with.timeIntegration.gamma},
                             0,        images.empty() ? nullptr : &images,
                             &contacts};
        return fsiStep<Dim>(step, with).nodes;
    };
    const auto step = [&](const Nodes<Dim>& from) {
        const auto constraints = constraintsOver(t, t + moment);
        t += moment;
        return over(controls, constraints, from, moment);
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
    const Nodes<Dim> first = over(asGiven, constraintsOver(0, firstStep), start, firstStep);
    start.p = first.p;
    start.a = first.a;
    return start;
}

#define PFEM_INSTANTIATE(D)                                                                                \
    template Nodes<D> consistentStart<D>(Problem<D>, const Controls&, const State<D>&, const Topology<D>&, \
                                         const ConstraintsOver<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
