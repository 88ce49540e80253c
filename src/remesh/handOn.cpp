#include "remesh/handOn.hpp"

#include <cmath>

#include "base/chosen.hpp"
#include "state/images.hpp"

namespace pfem {

template <int Dim>
void handOn(const Topology<Dim>& topology, const State<Dim>& state, std::vector<double> capacity,
            std::vector<double>& amounts) {
    constexpr int rows = 4;
    const auto images = imagesOf<Dim>(state);
    const auto& ring = topology.ring;
    images.follow(capacity);
    images.follow(amounts);
    const int nOwn = nOwnNodes<Dim>(state);
    for (int turn = 0; turn < rows; ++turn) {
        const std::vector<double> before = amounts;
        std::vector<double> sum(nOwn);  // what the neighbours can take
        const auto givers = parallelChosen(nOwn, [&](int i) {
            if (std::abs(before[i]) <= capacity[i]) return false;
            for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) sum[i] += capacity[ring.node[s]];
            return sum[i] != 0;
        });
        for (const int i : givers) {
            const double excess = before[i] - std::copysign(capacity[i], before[i]);
            amounts[i] -= excess;
            for (int s = ring.start[i]; s < ring.start[i + 1]; ++s)
                amounts[images.own(ring.node[s])] += excess * (capacity[ring.node[s]] / sum[i]);
        }
        images.follow(amounts);
        if (givers.empty()) return;
    }
}

#define PFEM_INSTANTIATE(D) \
    template void handOn<D>(const Topology<D>&, const State<D>&, std::vector<double>, std::vector<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
