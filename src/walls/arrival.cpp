#include "walls/arrival.hpp"

#include <algorithm>

#include "mesh/onFace.hpp"

namespace pfem {

template <int Dim>
bool isHeldBy(const Topology<Dim>& topology, const Supports<Dim>& supports, int wall) {
    return std::any_of(supports.begin(), supports.end(),
                       [&](int own) { return own >= 0 && topology.joined(own, wall); });
}

template <int Dim>
Arrivals<Dim>::Arrivals(double distance, const Topology<Dim>& topology, const Points<Dim>& xOld,
                        const Nodes<Dim>& nodes)
    : distance_(distance), topology_(topology), xOld_(xOld), nodes_(nodes), bins_(topology.walls, nodes.x, xOld) {
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.wallPoint[i]) travel_ = std::max(travel_, (nodes.x[i] - xOld[i]).norm());
    for (const auto& wall : topology.walls) {
        normal_.push_back(inwardNormal<Dim>(nodes.x, wall.nodes));
        normalOld_.push_back(inwardNormal<Dim>(xOld, wall.nodes));
    }
}

template <int Dim>
Arrival Arrivals<Dim>::first(int i, const std::function<bool(int wall)>& wanted) const {
    const Vec<Dim>&x = nodes_.x[i], &old = xOld_[i];
    Arrival first;
    // the foot of a place behind a face is no farther away than the way to it was long
    const double radius = distance_ * nodes_.h[i] + (x - old).norm() + travel_;
    bins_.forEachNear(x.cwiseMin(old), x.cwiseMax(old), radius, [&](int wall) {
        if (!wanted(wall)) return;
        const Arrival arrival = at(i, wall);
        if (arrival.part > first.part || (arrival.part == first.part && wall >= first.wall)) return;
        if (!isHeldBy<Dim>(topology_, nodes_.wall[i], wall)) first = arrival;
    });
    return first;
}

template <int Dim>
Arrival Arrivals<Dim>::at(int i, int wall) const {
    const Face<Dim>& face = topology_.walls[wall].nodes;
    const Vec<Dim>&x = nodes_.x[i], &old = xOld_[i];
    const double h = nodes_.h[i], after = normal_[wall].dot(x - nodes_.x[face[0]]);
    if (after > distance_ * h) return {};
    const double before = normalOld_[wall].dot(old - xOld_[face[0]]);
    if (before < -1e-9 * h || after >= before) return {};  // was behind, or leaves
    constexpr double roundOff = 1e-6;                      // of h, where faces meet
    const double part = after < 0 ? std::max(0.0, before / (before - after)) : 1;
    const double slack = roundOff * h / (nodes_.x[face[1]] - nodes_.x[face[0]]).norm();
    const auto isOn = [&](const Vec<Dim>& weights) { return weights.minCoeff() > -slack; };
    const bool crosses = part < 1 && isOn(footWeights<Dim>(xOld_, face, old + part * (x - old)));
    const bool drop = topology_.isolated(i);
    if (!crosses && ((drop && after < 0) || !isOn(footWeights<Dim>(nodes_.x, face, x)))) return {};
    return {crosses && drop ? part : 1, wall};
}

#define PFEM_INSTANTIATE(D)     \
    template class Arrivals<D>; \
    template bool isHeldBy<D>(const Topology<D>&, const Supports<D>&, int);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
