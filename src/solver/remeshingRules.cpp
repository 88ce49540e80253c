#include "solver/remeshingRules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conditions/inflow.hpp"
#include "conditions/sides.hpp"
#include "mesh/contacts.hpp"
#include "remesh/holdSizes.hpp"
#include "remesh/letGo.hpp"
#include "remesh/lostVolume.hpp"
#include "remesh/motionAccount.hpp"
#include "remesh/surfaceShift.hpp"
#include "solver/courantRate.hpp"
#include "solver/fluidEnergy.hpp"
#include "solver/impact.hpp"
#include "solver/invariants.hpp"
#include "walls/backs.hpp"
#include "walls/dryInlets.hpp"
#include "walls/landing.hpp"
#include "walls/openings.hpp"
#include "walls/penetration.hpp"
#include "walls/pinched.hpp"
#include "walls/release.hpp"

namespace pfem {

namespace {

/// Part of the lost volume for which the surface gives way in a step: all of it, but in steps of several periods of the
/// shortest waves, where it would come back in turns (doc/decisions.md).
template <int Dim>
double surfaceShare(const Problem<Dim>& problem, double dt, const Nodes<Dim>& nodes) {
    double h = std::numeric_limits<double>::max();
    for (const double size : nodes.h) h = std::min(h, size);
    return std::min(1.0, 10 * h / (problem.gravity.norm() * dt * dt));
}

/// The densest fluid of the case.
template <int Dim>
ViscousFluid heaviestFluid(const Problem<Dim>& problem) {
    ViscousFluid result;
    result.rho = 0;
    for (const auto& material : problem.materials)
        if (material.kind == MaterialKind::fluid && material.fluid.rho > result.rho) result = material.fluid;
    return result;
}

template <int Dim>
PassageStep<Dim> passageOf(const RemeshingContext<Dim>& c, const State<Dim>& state) {
    const double t0 = state.time.value;
    return {c.problem.conditions, c.motion.topology, c.motion.xOld, t0, t0 + c.motion.dt};
}

template <int Dim>
void comeIn(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    drawFromInlets<Dim>(passageOf<Dim>(c, state), c.controls.expert.walls, state);
}

template <int Dim>
void wetInlets(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    const auto step = passageOf<Dim>(c, state);
    if (!c.problem.period.any()) return fillDryInlets<Dim>(step, state);
    const int dry = dryInlet<Dim>(step, state);
    if (dry >= 0)
        throw StepFailure("the inlet '" + state.mesh.patches[dry].name +
                          "' has fallen dry: between periodic sides an inlet must stay wet");
}

template <int Dim>
void goOut(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>& outcome) {
    outcome.leaving = letThroughOutlets<Dim>(passageOf<Dim>(c, state), state);
}

template <int Dim>
bool hasInlets(const RemeshingContext<Dim>& c, const State<Dim>&) {
    return c.problem.conditions.anyInlet();
}

template <int Dim>
bool hasOutlets(const RemeshingContext<Dim>& c, const State<Dim>&) {
    return c.problem.conditions.anyOutlet();
}

template <int Dim>
void makeUpAtSurface(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    const Motion<Dim>& m = c.motion;
    shiftSurface<Dim>(c.controls, m.topology, m.returned, surfaceShare<Dim>(c.problem, m.dt, state.nodes), state);
}

template <int Dim>
void release(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    releaseFromWalls<Dim>(c.controls.walls, c.motion.topology, c.problem.gravity, heaviestFluid<Dim>(c.problem),
                          c.motion.dt, state.nodes);
}

template <int Dim>
void land(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    landOnWalls<Dim>(c.controls.expert.walls, c.motion.topology, c.motion.xOld, c.problem.gravity.norm(), state);
}

template <int Dim>
void keepOff(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    keepOffBacks<Dim>(c.motion.topology, state.nodes);
}

template <int Dim>
void putBack(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>& outcome) {
    const auto returned = returnPenetrating<Dim>(c.motion.topology, c.controls.expert.walls.wallDistance, state);
    outcome.returned = returned.number;
    outcome.pinched = returned.behind;
}

/// What is between closing surfaces goes; its volume comes back in the water nearby.
template <int Dim>
void squeezeOut(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>& outcome) {
    for (const int i : pinchedNodes<Dim>(c.motion.topology, 2 * c.controls.expert.walls.wallDistance, state))
        if (std::find(outcome.leaving.begin(), outcome.leaving.end(), i) == outcome.leaving.end())
            outcome.pinched.push_back(i);
}

/// What all the motions have changed is taken from what the nodes lack; what pressure has taken is not lost.
template <int Dim>
void chargeNodes(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    for (int i = 0; i < state.nodes.size(); ++i) state.nodes.lostVolume[i] += c.motion.compressed[i];
    chargeMotion<Dim>(c.motion.topology.fluid, state.mesh.fluid.nodes, c.motion.xOld, state.nodes);
}

template <int Dim>
void findLeavers(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>& outcome) {
    for (const int drop :
         goneForGood<Dim>(c.motion.topology, c.problem.gravity, c.problem.conditions.anyMotion(), state))
        if (std::find(outcome.leaving.begin(), outcome.leaving.end(), drop) == outcome.leaving.end())
            outcome.leaving.push_back(drop);
}

template <int Dim>
void takeSizesOfPlaces(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>&) {
    holdSizes<Dim>(c.motion.topology, c.problem.period, state);
}

template <int Dim>
bool sizesHold(const RemeshingContext<Dim>&, const State<Dim>& state) {
    return state.sizes.hold();
}

template <int Dim>
void reconnect(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>& outcome) {
    const auto& kinds = c.problem.conditions.kind;
    const bool sameWalls = c.motion.wallsOld == state.nodes.wall;
    if (sameWalls && outcome.returned == 0 && outcome.pinched.empty() &&
        !isDistorted<Dim>(c.controls.distortion, state.nodes.x, state.mesh.fluid.nodes))
        return;
    auto topology = c.motion.topology;
    if (c.problem.contact.on)
        topology = withContacts<Dim>(state.mesh, kinds, state.nodes.x, state.nodes.wall, std::move(topology));
    else if (!sameWalls)
        topology = withWalls<Dim>(state.mesh, kinds, state.nodes.x, state.nodes.wall, std::move(topology));
    const auto images = imagesOf<Dim>(state);
    auto& leaving = outcome.leaving;
    leaving.erase(std::remove_if(leaving.begin(), leaving.end(), [&](int i) { return images.isImage(i); }),
                  leaving.end());
    const auto sides = sidesOf<Dim>(c.problem, state);
    auto lips = lipNodes<Dim>(c.problem.conditions, topology, state.nodes);
    outcome.connectivity = remesh<Dim>({c.controls, kinds, std::move(topology), c.motion.dt, leaving, outcome.pinched,
                                        sides.period.any() ? &sides : nullptr, std::move(lips)},
                                       c.triangulator, state);
}

/// v + dv, or as much of dv as leaves the speed within `limit`, that of v at least.
template <int Dim>
Vec<Dim> fasterBy(const Vec<Dim>& v, const Vec<Dim>& dv, double limit) {
    const double room = std::max(limit * limit - v.squaredNorm(), 0.0), a = dv.squaredNorm(), b = v.dot(dv);
    return a + 2 * b <= room ? Vec<Dim>(v + dv) : Vec<Dim>(v + (std::sqrt(b * b + a * room) - b) / a * dv);
}

/// What has been meshed anew keeps its momentum, but for what walls and solids hold and what would make the fastest
/// node of all faster.
template <int Dim>
void giveMomentum(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>& outcome) {
    if (!outcome.connectivity) return;
    auto& nodes = state.nodes;
    const auto& conditions = c.problem.conditions;
    const auto topology = makeTopology<Dim>(state.mesh, conditions.kind, nodes.x, nodes.wall);
    const double t = state.time.value + c.motion.dt, limit = allowedSpeed<Dim>(topology, nodes);
    const auto constraints = nodeConstraints<Dim>(state.mesh, conditions, topology, nodes, t, t);
    const auto& missing = outcome.connectivity->missing;
    for (int i = 0; i < static_cast<int>(missing.size()); ++i)
        if (!topology.onSolid[i] && !topology.onOpening(i))
            nodes.v[i] = fasterBy<Dim>(nodes.v[i], constraints.project(i, missing[i]), limit);
}

template <int Dim>
bool keepsMomentum(const RemeshingContext<Dim>& c, const State<Dim>&) {
    return c.controls.keepMomentum;
}

template <int Dim>
void stopEachOther(const RemeshingContext<Dim>& c, State<Dim>& state, RemeshingOutcome<Dim>& outcome) {
    if (!outcome.connectivity) return;
    const auto& [contacts, gaps] = std::tie(outcome.connectivity->contacts, outcome.connectivity->gaps);
    const double met = closingRate<Dim>(state.nodes, contacts, c.controls.contactHeight);
    strike<Dim>(c.problem, contacts, state);
    state.approach = std::max(met, closingRate<Dim>(state.nodes, gaps, 0));
}

template <int Dim>
bool hasSolids(const RemeshingContext<Dim>&, const State<Dim>& state) {
    return !state.mesh.solid.nodes.empty();
}

template <int Dim>
bool solidsMeet(const RemeshingContext<Dim>& c, const State<Dim>& state) {
    return c.problem.contact.on && !state.mesh.solid.nodes.empty();
}

/// In the plane faces of walls are constraints of the triangulation.
template <int Dim>
bool inSpace(const RemeshingContext<Dim>&, const State<Dim>&) {
    return Dim == 3;
}

/// A gravity that turns could bring drops back.
template <int Dim>
bool dropsMayGo(const RemeshingContext<Dim>& c, const State<Dim>&) {
    const auto stays = [](const auto& function) { return !function || function->isConstant(); };
    return c.controls.letGo && stays(c.problem.gravityOverTime) && stays(c.problem.frameOverTime);
}

}  // namespace

template <int Dim>
const std::vector<RemeshingRule<Dim>>& remeshingRules() {
    static const std::vector<RemeshingRule<Dim>> rules{
        {"inlets", VolumeCause::inflow, comeIn<Dim>, hasInlets<Dim>},
        {"outlets", VolumeCause::outflow, goOut<Dim>, hasOutlets<Dim>},
        {"surfaceShift", VolumeCause::surface, makeUpAtSurface<Dim>},
        {"releaseFromWalls", VolumeCause::released, release<Dim>},
        {"landOnWalls", VolumeCause::landed, land<Dim>},
        {"keepOffBacks", VolumeCause::landed, keepOff<Dim>, inSpace<Dim>},
        {"returnPenetrating", VolumeCause::returned, putBack<Dim>, hasSolids<Dim>},
        {"squeezeOut", {}, squeezeOut<Dim>, solidsMeet<Dim>},
        {"chargeMotion", {}, chargeNodes<Dim>},
        {"letGo", {}, findLeavers<Dim>, dropsMayGo<Dim>},
        {"holdSizes", {}, takeSizesOfPlaces<Dim>, sizesHold<Dim>},
        {"remesh", {}, reconnect<Dim>},
        {"keepMomentum", {}, giveMomentum<Dim>, keepsMomentum<Dim>},
        {"strike", {}, stopEachOther<Dim>},
        {"dryInlets", {}, wetInlets<Dim>, hasInlets<Dim>},
    };
    return rules;
}

template <int Dim>
RemeshingOutcome<Dim> runRules(const std::vector<RemeshingRule<Dim>>& rules, const RemeshingContext<Dim>& context,
                               State<Dim>& state) {
    RemeshingOutcome<Dim> outcome;
    MotionAccount<Dim> account(state, context.triangulator.ranks());
    const auto total = [&] { return fluidEnergy<Dim>(context.problem, state, context.mass).total(); };
    const double energy = total();
    const auto sides = sidesOf<Dim>(context.problem, state);
    for (const auto& rule : rules) {
        if (rule.applies && !rule.applies(context, state)) continue;
        rule.run(context, state, outcome);
        if (sides.period.any()) keepImages<Dim>(sides, state);
        if (rule.cause) account.book(*rule.cause, state);
    }
    state.energy.book(EnergyCause::remeshing, total() - energy);
    return outcome;
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template const std::vector<RemeshingRule<D>>& remeshingRules<D>();                                         \
    template RemeshingOutcome<D> runRules<D>(const std::vector<RemeshingRule<D>>&, const RemeshingContext<D>&, \
                                             State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
