#include "remesh/bringUp.hpp"

#include <cmath>

#include "state/images.hpp"

namespace pfem {

template <int Dim>
void bringUp(const Topology<Dim>& topology, const State<Dim>& state, const std::vector<int>& surface,
             std::vector<double>& amounts) {
    const auto images = imagesOf<Dim>(state);
    const auto& ring = topology.ring;
    const auto neighbours = [&](int i, const auto& visit) {
        for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) visit(images.own(ring.node[s]));
    };
    constexpr int unknown = -1;
    std::vector<int> row(amounts.size(), unknown), upwards;
    for (const int i : surface)
        if (!images.isImage(i)) upwards.push_back(i);
    const std::size_t nSurface = upwards.size();
    for (const int i : upwards) row[i] = 0;
    for (std::size_t k = 0; k < upwards.size(); ++k) {
        const int i = upwards[k];
        neighbours(i, [&](int j) {
            if (row[j] != unknown) return;
            row[j] = row[i] + 1;
            upwards.push_back(j);
        });
    }
    for (std::size_t k = upwards.size(); k-- > nSurface;) {
        const int i = upwards[k];
        int heirs = 0;
        neighbours(i, [&](int j) { heirs += row[j] < row[i]; });
        const double part = amounts[i] / heirs;
        neighbours(i, [&](int j) { amounts[j] += row[j] < row[i] ? part : 0; });
        amounts[i] = 0;
    }
    images.follow(amounts);
}

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
        bool any = false;
        for (int i = 0; i < nOwn; ++i) {
            if (std::abs(before[i]) <= capacity[i]) continue;
            double sum = 0;
            for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) sum += capacity[ring.node[s]];
            if (sum == 0) continue;
            any = true;
            const double excess = before[i] - std::copysign(capacity[i], before[i]);
            amounts[i] -= excess;
            for (int s = ring.start[i]; s < ring.start[i + 1]; ++s)
                amounts[images.own(ring.node[s])] += excess * (capacity[ring.node[s]] / sum);
        }
        images.follow(amounts);
        if (!any) return;
    }
}

#define PFEM_INSTANTIATE(D)                                                                                       \
    template void bringUp<D>(const Topology<D>&, const State<D>&, const std::vector<int>&, std::vector<double>&); \
    template void handOn<D>(const Topology<D>&, const State<D>&, std::vector<double>, std::vector<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
