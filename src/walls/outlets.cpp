#include <algorithm>
#include <set>

#include "conditions/wallFreedom.hpp"
#include "mesh/locate.hpp"
#include "walls/arrival.hpp"
#include "walls/openings.hpp"
#include "walls/passage.hpp"

namespace pfem {

namespace {

template <int Dim>
class Outflow {
public:
    Outflow(const PassageStep<Dim>& step, State<Dim>& state)
        : topology_(step.topology),
          conditions_(step.conditions),
          xOld_(step.xOld),
          state_(state),
          nodes_(state.nodes),
          arrivals_(0, step.topology, step.xOld, state.nodes),
          x_(state.nodes.x),
          v_(state.nodes.v) {}

    std::vector<int> run() {
        for (int i = 0; i < topology_.nNodes(); ++i)
            if (outletOf(i) >= 0 && nSupports(nodes_.wall[i]) == Dim) corners_.insert(nodes_.wall[i]);
        for (int i = 0; i < topology_.nNodes(); ++i) {
            if (!topology_.ofFluid(i)) continue;
            const int wall = outletOf(i);
            if (topology_.isolated(i)) {
                if (wall >= 0 || reached(i) >= 0) leave(i);
            } else if (wall >= 0)
                putBack(i, wall);
            else
                arrive(i);
        }
        nodes_.v = std::move(v_);
        takeLost();
        moveNodes<Dim>(std::move(x_), state_);
        return std::move(leaving_);
    }

private:
    /// Water that leaves takes its part of what nodes lack (or have too much of) along: that, too, has left, and is no
    /// error any more.
    void takeLost() {
        std::vector<double> volume(nodes_.size(), 0.0), left(nodes_.size(), 0.0);
        for (const auto& cell : state_.mesh.fluid.nodes) {
            const double before = simplexMeasure<Dim>(nodes_.x, cell);
            const double part = before - simplexMeasure<Dim>(x_, cell);
            for (const int i : cell) {
                volume[i] += before;
                left[i] += part;
            }
        }
        for (int i = 0; i < nOwnNodes<Dim>(state_); ++i) {  // images follow
            if (!(left[i] > 0 && volume[i] > 0)) continue;
            const double lost = nodes_.lostVolume[i] * std::min(1.0, left[i] / volume[i]);
            nodes_.lostVolume[i] -= lost;
            state_.ledger.book(VolumeCause::outflow, i, -lost);
            state_.ledger.book(VolumeCause::solver, i, lost);
        }
    }

    bool isOutlet(int wall) const {
        return topology_.walls[wall].patch >= 0 && conditions_.outlet[topology_.walls[wall].patch] != nullptr;
    }
    int outletOf(int i) const {
        for (const int wall : nodes_.wall[i])
            if (wall >= 0 && isOutlet(wall)) return wall;
        return -1;
    }

    double before(int wall, const Points<Dim>& places, const Vec<Dim>& point) const {
        return pfem::before<Dim>(topology_, wall, places, point);
    }

    /// Where node i comes to the plane of the outlet when it moves across it, along the walls that hold it.
    Vec<Dim> onPlane(int i, int wall) const {
        const Vec<Dim> n = inwardNormal<Dim>(nodes_.x, topology_.walls[wall].nodes);
        Supports<Dim> others = nodes_.wall[i];
        for (const int own : nodes_.wall[i])
            if (own >= 0 && isOutlet(own)) dropSupport(others, own);
        const Vec<Dim> along = freedomOn<Dim>(topology_.walls, nodes_.x, others).project(n);
        const double part = along.dot(n);
        if (!(part > 1e-6)) return xOld_[i];
        return nodes_.x[i] - along * (before(wall, nodes_.x, nodes_.x[i]) / part);
    }

    /// Where the free surface at node i crosses the plane; at what is beyond by the mean of its faces.
    Vec<Dim> surfaceOnPlane(int i, int wall, const Vec<Dim>& otherwise) const {
        const double own = before(wall, nodes_.x, nodes_.x[i]);
        Vec<Dim> sum = Vec<Dim>::Zero();
        int count = 0;
        if (own < 0)
            for (const auto& face : topology_.faces) {
                if (face.kind != FaceKind::freeSurface ||
                    std::find(face.nodes.begin(), face.nodes.end(), i) == face.nodes.end())
                    continue;
                for (const int j : face.nodes) {
                    const double other = before(wall, nodes_.x, nodes_.x[j]);
                    if (j == i || outletOf(j) >= 0 || other <= 0) continue;
                    sum += nodes_.x[i] + (own / (own - other)) * (nodes_.x[j] - nodes_.x[i]);
                    ++count;
                }
            }
        return count > 0 ? Vec<Dim>(sum / count) : otherwise;
    }

    /// The moved water's velocity at a place near node i: in the cell around it in which the place lies deepest, or in
    /// the point of that cell with the nearest weights.
    Vec<Dim> velocityAt(int i, const Vec<Dim>& place) const {
        WeightedNodes<Dim> best;
        double deepest = -1e300;
        const auto& around = topology_.fluid;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const auto& cell = state_.mesh.fluid.nodes[around.cell[s]];
            if (!(simplexMeasure<Dim>(nodes_.x, cell) > 0)) continue;
            const auto weights = barycentric<Dim>(cell, nodes_.x, place);
            if (weights.minCoeff() <= deepest) continue;
            deepest = weights.minCoeff();
            best = {cell, weights, around.cell[s]};
        }
        if (best.cell < 0) return nodes_.v[i];
        best.weights = best.weights.cwiseMax(0).eval();
        best.weights /= best.weights.sum();
        return interpolate<Dim>(best, nodes_.v);
    }

    void putBack(int i, int wall) {
        x_[i] = onPlane(i, wall);
        if (topology_.freeSurface[i] && nSupports(nodes_.wall[i]) == 1) x_[i] = surfaceOnPlane(i, wall, x_[i]);
        if (before(wall, nodes_.x, nodes_.x[i]) < 0) v_[i] = velocityAt(i, x_[i]);
    }

    int reached(int i) const {
        return arrivals_.first(i, [this](int wall) { return isOutlet(wall); }).wall;
    }

    void arrive(int i) {
        const int wall = reached(i);
        if (wall < 0 || nSupports(nodes_.wall[i]) == Dim) return;
        Supports<Dim> walls = nodes_.wall[i];
        addSupport(walls, wall);
        const Vec<Dim> place = onPlane(i, wall);
        if (nSupports(walls) == Dim && !corners_.insert(walls).second) {  // node control is going to take it out
            x_[i] = place + 0.05 * nodes_.h[i] * inwardNormal<Dim>(nodes_.x, topology_.walls[wall].nodes);
            return;
        }
        x_[i] = place;
        nodes_.wall[i] = walls;
    }

    void leave(int i) {
        if (i >= nOwnNodes<Dim>(state_)) return;  // images go with their masters
        state_.ledger.book(VolumeCause::outflow, i, -nodes_.dropVolume[i]);
        nodes_.dropVolume[i] = 0;
        leaving_.push_back(i);
    }

    const Topology<Dim>& topology_;
    const BoundaryConditions<Dim>& conditions_;
    const Points<Dim>& xOld_;
    State<Dim>& state_;
    Nodes<Dim>& nodes_;
    Arrivals<Dim> arrivals_;
    Points<Dim> x_, v_;
    std::set<Supports<Dim>> corners_;  // where there is a node
    std::vector<int> leaving_;
};

}  // namespace

template <int Dim>
std::vector<int> letThroughOutlets(const PassageStep<Dim>& step, State<Dim>& state) {
    return Outflow<Dim>(step, state).run();
}

#define PFEM_INSTANTIATE(D) template std::vector<int> letThroughOutlets<D>(const PassageStep<D>&, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
