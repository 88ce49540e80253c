#include <algorithm>

#include "conditions/inflow.hpp"
#include "mesh/distance.hpp"
#include "walls/arrival.hpp"
#include "walls/openings.hpp"
#include "walls/passage.hpp"

namespace pfem {

namespace {

/// Water that comes to an inlet from outside of its stream: it is held there as by a wall. The nodes.
template <int Dim>
std::vector<int> landOnInlets(const PassageStep<Dim>& step, double landingDistance, Nodes<Dim>& nodes, Points<Dim>& x) {
    const auto& topology = step.topology;
    std::vector<int> landed;
    const auto isInlet = [&](int w) { return step.conditions.inlet[topology.walls[w].patch] != nullptr; };
    const Arrivals<Dim> arrivals(landingDistance, topology, step.xOld, nodes);
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (!topology.ofFluid(i) || topology.onOpening(i) || nSupports(nodes.wall[i]) == Dim) continue;
        const int wall = arrivals.first(i, isInlet).wall;
        if (wall < 0) continue;
        x[i] = placeOnRegion<Dim>(topology.walls, nodes.x, wall, nodes.x[i]).x;
        addSupport(nodes.wall[i], wall);
        landed.push_back(i);
    }
    return landed;
}

}  // namespace

template <int Dim>
void holdAtLips(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, Nodes<Dim>& nodes) {
    const auto isInlet = [&](int w) {
        return topology.walls[w].patch >= 0 && conditions.inlet[topology.walls[w].patch] != nullptr;
    };
    for (int w = 0; w < static_cast<int>(topology.walls.size()); ++w) {
        if (!isInlet(w)) continue;
        for (int i = 0; i < topology.nNodes(); ++i)
            for (int& own : nodes.wall[i])
                if (own >= 0 && !isInlet(own) && topology.walls[own].region == topology.walls[w].region &&
                    distanceToFace<Dim>(nodes.x, topology.walls[w].nodes, nodes.x[i]) < 1e-6 * nodes.h[i])
                    own = w;
    }
}

template <int Dim>
void drawFromInlets(const PassageStep<Dim>& step, const WallDistances& controls, State<Dim>& state) {
    const auto& [conditions, topology, xOld, t0, t1] = step;
    Nodes<Dim>& nodes = state.nodes;
    const auto inflow = inflowOf<Dim>(conditions, topology, xOld, nodes, t0, t1);
    Points<Dim> x = nodes.x;
    for (const auto& [i, motion, pinned] : inflow.driven) {
        x[i] = pinned ? xOld[i] : Vec<Dim>(x[i] - (motion.to - motion.from));
        if (pinned) continue;
        for (int& wall : nodes.wall[i]) {  // it slides up and down, and on over a wall beside the inlet
            if (wall < 0 || !topology.isOpening(wall)) continue;
            const auto place = placeOnRegion<Dim>(topology.walls, x, wall, x[i]);
            x[i] = place.x;
            wall = place.face;
        }
    }
    auto takers = landOnInlets<Dim>(step, controls.landingDistance, nodes, x);
    const double excess = moveNodes<Dim>(std::move(x), state) - inflow.volume;
    state.ledger.book(VolumeCause::inflow, -excess);
    state.ledger.book(VolumeCause::solver, excess);
    for (const auto& one : inflow.driven) takers.push_back(one.node);
    const int nOwn = nOwnNodes<Dim>(state);  // images take what their masters do
    takers.erase(std::remove_if(takers.begin(), takers.end(), [&](int i) { return i >= nOwn; }), takers.end());
    for (const int i : takers) {
        const double part = excess / static_cast<double>(takers.size());
        state.ledger.place(VolumeCause::inflow, i, -part);
        state.ledger.place(VolumeCause::solver, i, part);
        nodes.lostVolume[i] -= part;
    }
}

#define PFEM_INSTANTIATE(D)                                                                   \
    template void holdAtLips<D>(const BoundaryConditions<D>&, const Topology<D>&, Nodes<D>&); \
    template void drawFromInlets<D>(const PassageStep<D>&, const WallDistances&, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
