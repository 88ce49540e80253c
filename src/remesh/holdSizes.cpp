#include "remesh/holdSizes.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "remesh/sizeTree.hpp"

namespace pfem {

namespace {

/// The sizes that places and solids ask for, where they are now.
template <int Dim>
class WantedSize {
public:
    WantedSize(const Topology<Dim>& topology, const State<Dim>& state) : state_(state) {
        for (const auto& place : state.sizes.places) {
            for (const auto& corners : place.faces) tree_.add(corners, place.meshSize, place.distance);
            if (!place.patch.empty()) addPatch(place);
        }
        addSolids(topology.solidFaces);
        tree_.build();
    }

    double at(const Vec<Dim>& x, double most) const {
        for (const auto& place : state_.sizes.places)
            if (place.box) {
                const double away = distanceToBox<Dim>(x, (*place.box)[0], (*place.box)[1]);
                most = std::min(most, place.meshSize + sizeGrowth * away);
            }
        return tree_.at(x, most);
    }

private:
    typename SizePlace<Dim>::Corners cornersOf(const Face<Dim>& face) const {
        typename SizePlace<Dim>::Corners corners;
        for (int k = 0; k < Dim; ++k) corners[k] = state_.nodes.x[face[k]];
        return corners;
    }

    void addPatch(const SizePlace<Dim>& place) {
        for (const auto& patch : state_.mesh.patches)
            if (patch.name == place.patch)
                for (const auto& face : patch.faces) tree_.add(cornersOf(face), place.meshSize, place.distance);
    }

    void addSolids(const std::vector<BoundaryFace<Dim>>& faces) {
        for (const auto& face : faces) {
            double size = state_.sizes.coarsest;
            for (const int i : face.nodes) size = std::min(size, state_.nodes.h[i]);
            if (size < state_.sizes.coarsest) tree_.add(cornersOf(face.nodes), size, 0);
        }
    }

    const State<Dim>& state_;
    SizeTree<Dim> tree_;
};

}  // namespace

template <int Dim>
void holdSizes(const Topology<Dim>& topology, const Period<Dim>& period, State<Dim>& state) {
    const WantedSize<Dim> wanted(topology, state);
    auto shifts = shiftsOf<Dim>(period);
    shifts.push_back({});
    std::vector<double> h = state.nodes.h;
    parallelFor(state.nodes.size(), [&](int i) {
        if (!topology.ofFluid(i) || topology.onSolid[i]) return;
        h[i] = state.sizes.coarsest;
        for (const auto& shift : shifts) h[i] = wanted.at(state.nodes.x[i] + period.times(shift), h[i]);
    });
    state.nodes.h = std::move(h);
}

#define PFEM_INSTANTIATE(D) template void holdSizes<D>(const Topology<D>&, const Period<D>&, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
