#include "remesh/letGo.hpp"

#include <algorithm>

namespace pfem {

namespace {

/// Lower and upper ends of a cloud of vectors.
template <int Dim>
struct Box {
    Vec<Dim> low = Vec<Dim>::Constant(1e300), high = -low;

    void add(const Vec<Dim>& x) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    double size() const { return (high - low).norm(); }
    /// How far x is beyond the end in a direction of axis d, `sign` 1 or -1; negative: before it.
    double beyond(const Vec<Dim>& x, int d, int sign) const { return sign > 0 ? x[d] - high[d] : low[d] - x[d]; }
};

}  // namespace

template <int Dim>
std::vector<int> goneForGood(const Topology<Dim>& topology, const Vec<Dim>& gravity, bool moving,
                             const State<Dim>& state) {
    const auto& nodes = state.nodes;
    const auto kept = keptNodes<Dim>(state.mesh, nodes.size());  // of walls, other patches and solids
    Box<Dim> places, velocities;
    std::vector<int> drops, gone;
    for (int i = 0; i < nodes.size(); ++i)
        if (topology.isolated(i) && !kept[i]) {
            if (!isSupported(nodes.wall[i])) drops.push_back(i);
        } else {
            places.add(nodes.x[i]);
            velocities.add(nodes.v[i]);
        }
    if (std::count(kept.begin(), kept.end(), 1) == 0)
        return {};  // neither walls nor solids: nothing that could be left
    velocities.add(Vec<Dim>::Zero());
    const auto leaves = [&](int i) {
        const double away = moving ? places.size() : 2 * nodes.h[i];
        for (int d = 0; d < Dim; ++d)
            for (const int sign : {-1, 1})
                if (places.beyond(nodes.x[i], d, sign) > away && velocities.beyond(nodes.v[i], d, sign) >= 0 &&
                    sign * gravity[d] >= 0)
                    return true;
        return false;
    };
    std::copy_if(drops.begin(), drops.end(), std::back_inserter(gone), leaves);
    return gone;
}

#define PFEM_INSTANTIATE(D) \
    template std::vector<int> goneForGood<D>(const Topology<D>&, const Vec<D>&, bool, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
