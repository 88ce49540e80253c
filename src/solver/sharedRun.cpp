#include "solver/sharedRun.hpp"

#include <algorithm>
#include <cstring>

#include "base/error.hpp"

namespace pfem {

namespace {

/// A number that differs when a bit of the places, velocities or pressures does (Fowler, Noll and Vo).
template <int Dim>
std::uint64_t digest(const Nodes<Dim>& nodes) {
    std::uint64_t sum = 14695981039346656037u;
    const auto add = [&](double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        sum = (sum ^ bits) * 1099511628211u;
    };
    for (int i = 0; i < nodes.size(); ++i) {
        for (int d = 0; d < Dim; ++d) {
            add(nodes.x[i][d]);
            add(nodes.v[i][d]);
        }
        add(nodes.p[i]);
    }
    return sum;
}

}  // namespace

template <int Dim>
void shareAmong(const Ranks& ranks, Simulation<Dim>& simulation) {
    if (Dim == 2) {
        if (ranks.isAlone()) return;
        throw UserError(
            "-parallel is for cases in three dimensions: in the plane only threads share the work (OMP_NUM_THREADS)");
    }
    const auto& h = simulation.state.nodes.h;
    const double largest = h.empty() ? 0 : *std::max_element(h.begin(), h.end());
    simulation.controls.continuity.ranks = ranks;
    simulation.triangulator = Triangulator<Dim>(ranks, 2 * simulation.controls.remeshing.expert.alpha * largest);
}

template <int Dim>
void agree(const Ranks& ranks, State<Dim>& state) {
    if (ranks.isAlone()) return;
    state.time = ranks.ofFirst(state.time);
    const auto digests = ranks.gather(std::vector<std::uint64_t>{digest<Dim>(state.nodes)});
    if (std::count(digests.begin(), digests.end(), digests[0]) != ranks.size())
        throw UserError(
            "the ranks have come to different states: all must run the same program on processors of one kind");
}

template <int Dim>
void followFirst(const Ranks& ranks, Simulation<Dim>& simulation) {
    if (simulation.state.time.index == 0) simulation.start(ranks.ofFirst(0.0));
    while (ranks.ofFirst(false)) {
        simulation.step(ranks.ofFirst(0.0));
        agree<Dim>(ranks, simulation.state);
    }
}

#define PFEM_INSTANTIATE(D)                                     \
    template void shareAmong<D>(const Ranks&, Simulation<D>&);  \
    template void followFirst<D>(const Ranks&, Simulation<D>&); \
    template void agree<D>(const Ranks&, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
