#include "remesh/passOn.hpp"

#include "remesh/heirs.hpp"

namespace pfem {

namespace {

/// An even part of `amount` for each of the nodes.
void share(double amount, const std::vector<int>& nodes, std::vector<double>& amounts) {
    for (const int node : nodes) amounts[node] += amount / static_cast<double>(nodes.size());
}

/// Nodes that are written into fluid.vtu: of cells, and what is neither of a solid nor of a patch, drops and others.
template <int Dim>
std::vector<unsigned char> fluidNodes(const State<Dim>& state, const std::vector<unsigned char>& wet) {
    const auto kept = keptNodes<Dim>(state.mesh, state.nodes.size());
    std::vector<unsigned char> result(wet.size());
    for (std::size_t i = 0; i < wet.size(); ++i) result[i] = wet[i] || !kept[i];
    return result;
}

/// An old node that has no place in the fluid (any more), and the new nodes that take over; none: all of the fluid.
struct Legacy {
    int old;
    std::vector<int> heirs;
};

/// Inserted nodes are in no solid and no patch: they have a place.
template <int Dim>
std::vector<Legacy> legacies(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex,
                             const std::vector<unsigned char>& wet, const std::vector<unsigned char>& fluid) {
    std::vector<Legacy> result;
    for (int i = 0; i < moved.topology.nNodes(); ++i) {
        if (newIndex[i] >= 0 && fluid[newIndex[i]]) continue;
        result.push_back({i, heirsOf<Dim>(moved, newIndex, wet, i)});
    }
    return result;
}

/// The old nodes' amounts added to `booked`, that of the new ones; then the heirs get theirs.
std::vector<double> passedOn(const std::vector<double>& old, const std::vector<int>& newIndex,
                             const std::vector<Legacy>& legacies, const std::vector<unsigned char>& fluid,
                             std::vector<double> booked) {
    for (std::size_t i = 0; i < old.size(); ++i)
        if (newIndex[i] >= 0) booked[newIndex[i]] += old[i];
    for (const auto& [i, heirs] : legacies) {
        const int node = newIndex[i];
        const double amount = node < 0 ? old[i] : booked[node];
        if (node >= 0) booked[node] = 0;
        if (amount != 0) share(amount, heirs.empty() ? chosen(fluid) : heirs, booked);
    }
    return booked;
}

}  // namespace

template <int Dim>
void postRemeshing(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex, VolumeLedger sheet,
                   State<Dim>& state) {
    if (state.ledger.counting()) {
        const auto wet = nodesIn<Dim>(state.mesh.fluid.nodes, state.nodes.size());
        const auto fluid = fluidNodes<Dim>(state, wet);
        const auto left = legacies<Dim>(moved, newIndex, wet, fluid);
        for (const auto& [cause, amounts] : state.ledger.fields()) {
            auto& booked = sheet.fields().at(cause);
            booked = passedOn(amounts, newIndex, left, fluid, std::move(booked));
        }
    }
    state.ledger.post(std::move(sheet));
}

#define PFEM_INSTANTIATE(D) \
    template void postRemeshing<D>(const MovedMesh<D>&, const std::vector<int>&, VolumeLedger, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
