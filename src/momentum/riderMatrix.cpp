#include "momentum/riderMatrix.hpp"

#include <map>

namespace pfem {

template <int Dim>
std::vector<SolidVelocity<Dim>> carriedBy(const SolidDofs<Dim>& dofs, const Rider<Dim>& rider) {
    std::map<int, double> along;  // the normal
    for (int k = 0; k < Dim; ++k) {
        const int node = rider.ride.face[k];
        for (int c = 0; c < dofs.count[node]; ++c)
            along[dofs.first[node] + c] +=
                rider.ride.weights[k] * rider.normal.dot(dofs.basis[dofs.local[node]].col(c));
    }
    std::vector<SolidVelocity<Dim>> result;
    for (const auto& [unknown, part] : along) result.push_back({unknown, part * rider.dual});
    return result;
}

template <int Dim>
void addRiders(const std::vector<Rider<Dim>>& riders, const Points<Dim>& inertia, SolidBlock<Dim>& block) {
    for (const auto& rider : riders) {
        const double mass = inertia[rider.ride.node].dot(rider.normal.cwiseAbs2());
        const auto carried = carriedBy<Dim>(block.dofs, rider);
        for (std::size_t a = 0; a < carried.size(); ++a)
            for (std::size_t b = 0; b <= a; ++b)
                block.matrix.add(carried[a].unknown, carried[b].unknown,
                                 mass * carried[a].velocity.dot(carried[b].velocity));
    }
}

#define PFEM_INSTANTIATE(D)                                                                    \
    template std::vector<SolidVelocity<D>> carriedBy<D>(const SolidDofs<D>&, const Rider<D>&); \
    template void addRiders<D>(const std::vector<Rider<D>>&, const Points<D>&, SolidBlock<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
