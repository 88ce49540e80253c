#include "solver/impact.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "conditions/constraints.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/simplex.hpp"
#include "momentum/mass.hpp"
#include "solver/inelastic.hpp"
#include "state/images.hpp"

namespace pfem {

namespace {

constexpr int mostTurns = 20;
constexpr double enough = 0.01;  // of the fastest closing

/// How patches and walls hold the nodes where they are, as in the momentum equation of the next step: the contact line
/// of a no-slip wall slides along it.
template <int Dim>
NodeConstraints<Dim> holdOf(const Problem<Dim>& problem, const State<Dim>& state) {
    const auto topology = makeTopology<Dim>(state.mesh, problem.conditions.kind, state.nodes.x, state.nodes.wall);
    return nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes, problem.time, problem.time);
}

/// The contacts without nodes of solids.
template <int Dim>
std::vector<Simplex<Dim>> betweenFluids(const std::vector<Simplex<Dim>>& contacts, const State<Dim>& state) {
    const auto ofSolid = nodesIn<Dim>(state.mesh.solid.nodes, state.nodes.size());
    std::vector<Simplex<Dim>> result;
    for (const auto& s : contacts)
        if (std::none_of(s.begin(), s.end(), [&](int i) { return ofSolid[i]; })) result.push_back(s);
    return result;
}

template <int Dim>
MeetingCell<Dim> meetingCell(const Simplex<Dim>& s, const Nodes<Dim>& nodes, const std::vector<double>& mass,
                             const NodeConstraints<Dim>& constraints) {
    MeetingCell<Dim> cell;
    cell.gradN = simplexGeometry<Dim>(nodes.x, s).gradN;
    for (int k = 0; k <= Dim; ++k) {
        cell.x[k] = nodes.x[s[k]];
        cell.v[k] = nodes.v[s[k]];
        cell.mass[k] = mass[s[k]];
        for (int d = 0; d < Dim; ++d) cell.freedom[k].col(d) = constraints.project(s[k], Vec<Dim>::Unit(d));
    }
    return cell;
}

/// Per node of the contacts the largest value of all that hang together by shared nodes; 0 elsewhere. `value`: of a
/// contact.
template <int Dim, class Value>
std::vector<double> largestTogether(const std::vector<Simplex<Dim>>& contacts, int nNodes, Value value) {
    std::vector<double> largest(nNodes, 0.0);
    for (const auto& s : contacts)
        for (int i : s) largest[i] = std::max(largest[i], value(s));
    for (bool again = true; again;) {
        again = false;
        for (const auto& s : contacts) {
            double most = 0;
            for (int i : s) most = std::max(most, largest[i]);
            for (int i : s) again = std::exchange(largest[i], most) < most || again;
        }
    }
    return largest;
}

/// The largest speed of the contacts' nodes.
template <int Dim>
double fastestOf(const std::vector<Simplex<Dim>>& contacts, const Points<Dim>& v) {
    double fastest = 0;
    for (const auto& s : contacts)
        for (int i : s) fastest = std::max(fastest, v[i].norm());
    return fastest;
}

/// The largest velocity in a contact against its centre of mass.
template <int Dim>
double apartIn(const Simplex<Dim>& s, const std::vector<double>& mass, const Points<Dim>& v) {
    Vec<Dim> momentum = Vec<Dim>::Zero();
    double sum = 0, largest = 0;
    for (int i : s) {
        momentum += mass[i] * v[i];
        sum += mass[i];
    }
    for (int i : s) largest = std::max(largest, (v[i] - momentum / sum).norm());
    return largest;
}

/// The largest speed at which a node of the contacts is held, that of a moving wall.
template <int Dim>
double fastestHold(const std::vector<Simplex<Dim>>& contacts, const Points<Dim>& v,
                   const NodeConstraints<Dim>& constraints) {
    double fastest = 0;
    for (const auto& s : contacts)
        for (int i : s) fastest = std::max(fastest, (v[i] - constraints.project(i, v[i])).norm());
    return fastest;
}

/// Sets the velocity of a node, and of all the others that stand for the same one beyond periodic sides.
template <int Dim>
class Velocities {
public:
    Velocities(const std::vector<Simplex<Dim>>& struck, const State<Dim>& state) : images_(imagesOf<Dim>(state)) {
        for (const auto& s : struck)
            for (const int i : s)
                if (images_.isImage(i)) struck_.insert({images_.own(i), i});
    }
    void set(int i, const Vec<Dim>& value, Points<Dim>& v) const {
        v[images_.own(i)] = value;
        const auto [begin, end] = struck_.equal_range(images_.own(i));
        for (auto image = begin; image != end; ++image) v[image->second] = value;
    }

private:
    Images<Dim> images_;
    std::multimap<int, int> struck_;  // the images of each master
};

}  // namespace

template <int Dim>
void strike(const Problem<Dim>& problem, const std::vector<Simplex<Dim>>& contacts, State<Dim>& state) {
    auto& nodes = state.nodes;
    const auto struck = betweenFluids<Dim>(contacts, state);
    if (std::none_of(struck.begin(), struck.end(),
                     [&](const auto& s) { return simplexDivergence<Dim>(nodes.x, nodes.v, s) < 0; }))
        return;
    const auto constraints = holdOf<Dim>(problem, state);
    const Velocities<Dim> velocities(struck, state);
    const auto mass = fluidMass<Dim>(problem, state.mesh.fluid, nodes.x);
    const double before = fastestOf<Dim>(struck, nodes.v);
    std::vector<unsigned char> meets(nodes.size(), 0);
    for (const auto& s : struck)
        for (int i : s) meets[i] = 1;
    Points<Dim> brought;  // to solids, which get it in the next step
    for (const auto& rider : constraints.riders)
        brought.push_back(rider.own(nodes.v[rider.ride.node]) - rider.carried(nodes.v));
    for (const auto& s : struck)  // what a wall holds from now on strikes nobody
        for (int i : s) velocities.set(i, constraints.velocity(i, nodes.x[i], nodes.v[i]), nodes.v);
    for (const auto& rider : constraints.riders)
        if (meets[rider.ride.node]) nodes.v[rider.ride.node] += rider.carried(nodes.v);
    const Points<Dim> held = nodes.v;
    const auto speed =
        largestTogether<Dim>(struck, nodes.size(), [&](const auto& s) { return fastestOf<Dim>({s}, held); });
    const auto apart =
        largestTogether<Dim>(struck, nodes.size(), [&](const auto& s) { return apartIn<Dim>(s, mass, held); });
    double fastest = 0;
    for (const auto& s : struck) fastest = std::max(fastest, -simplexDivergence<Dim>(nodes.x, nodes.v, s));
    bool closing = fastest > 0;
    for (int turn = 0; closing && turn < mostTurns; ++turn) {
        closing = false;
        for (const auto& s : struck) {
            auto cell = meetingCell<Dim>(s, nodes, mass, constraints);
            cell.speed = speed[s[0]];
            cell.apart = apart[s[0]];
            if (cell.divergence() >= -enough * fastest || !stopClosing<Dim>(cell)) continue;
            closing = true;
            for (int k = 0; k <= Dim; ++k) velocities.set(s[k], cell.v[k], nodes.v);
        }
    }
    // walls that move in several ways could play ball with a node
    const double limit = before + fastestHold<Dim>(struck, held, constraints);
    if (fastestOf<Dim>(struck, nodes.v) > limit * (1 + 1e-12)) nodes.v = held;
    for (std::size_t k = 0; k < brought.size(); ++k)
        if (const int i = constraints.riders[k].ride.node; meets[i]) nodes.v[i] += brought[k];
}

#define PFEM_INSTANTIATE(D) template void strike<D>(const Problem<D>&, const std::vector<Simplex<D>>&, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
