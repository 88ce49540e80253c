#include "continuity/riderColumns.hpp"

#include <set>

#include "mesh/simplex.hpp"
#include "mesh/skinPoints.hpp"

namespace pfem {

template <int Dim>
RiderColumns<Dim>::RiderColumns(const Step<Dim>& step, const SolidDofs<Dim>& dofs, const Points<Dim>& x) {
    const auto& riders = step.constraints.riders;
    if (riders.empty()) return;
    moved_.resize(x.size());
    flux_.resize(x.size());
    for (const int node : dofs.node)
        for (int c = 0; c < dofs.count[node]; ++c)
            moved_[node].push_back({dofs.first[node] + c, dofs.basis[dofs.local[node]].col(c)});
    for (const auto& rider : riders)
        for (const auto& carried : carriedBy<Dim>(dofs, rider)) moved_[rider.ride.node].push_back(carried);
    for (const auto& face : step.topology.faces)
        if (face.wall >= 0 && step.topology.isSkin(face.wall)) addFlux(step.topology, x, face);
}

template <int Dim>
void RiderColumns<Dim>::addFlux(const Topology<Dim>& topology, const Points<Dim>& x, const FluidFace<Dim>& face) {
    const Vec<Dim> area = faceArea<Dim>(x, face.nodes);
    for (const auto& point : skinPoints<Dim>(topology, x, face)) {
        const auto add = [&](int node, double weight) {
            for (const auto& [unknown, velocity] : moved_[node])
                for (int I = 0; I < Dim; ++I)
                    flux_[face.nodes[I]][unknown] += point.part * point.onFluid[I] * weight * area.dot(velocity);
        };
        for (int k = 0; k < Dim; ++k) {
            add(point.onSolid.face[k], point.onSolid.weights[k]);
            add(face.nodes[k], -point.onFluid[k]);
        }
    }
}

template <int Dim>
int RiderColumns<Dim>::count(const NodeToNodes& ring, int i) const {
    std::set<int> unknowns;
    for (const auto& [unknown, value] : flux_[i]) unknowns.insert(unknown);
    const auto look = [&](int node) {
        for (const auto& one : moved_[node]) unknowns.insert(one.unknown);
    };
    look(i);
    for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) look(ring.node[s]);
    return static_cast<int>(unknowns.size());
}

template <int Dim>
std::map<int, double> RiderColumns<Dim>::entries(int i, const std::vector<int>& nodes,
                                                 const std::vector<Vec<Dim>>& B) const {
    std::map<int, double> sum = flux_[i];
    for (std::size_t k = 0; k < nodes.size(); ++k)
        for (const auto& one : moved_[nodes[k]]) sum[one.unknown] += B[k].dot(one.velocity);
    return sum;
}

template class RiderColumns<2>;
template class RiderColumns<3>;

}  // namespace pfem
