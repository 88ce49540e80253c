#include "momentum/solidPattern.hpp"

#include <algorithm>

namespace pfem {

namespace {

/// Per node of the unknowns those that come after it and share a stress point with it, ascending.
template <int Dim>
std::vector<std::vector<int>> laterNodes(const PointRows<Dim>& rows, const SolidDofs<Dim>& dofs) {
    std::vector<std::vector<int>> later(dofs.node.size());
    parallelFor(static_cast<int>(later.size()), [&](int l) {
        const int node = dofs.node[l];
        for (const int p : rows.pointsOf(node))
            for (const int other : rows[p].nodes)
                if (dofs.local[other] >= 0 && dofs.first[other] > dofs.first[node])
                    later[l].push_back(dofs.local[other]);
        std::sort(later[l].begin(), later[l].end());
        later[l].erase(std::unique(later[l].begin(), later[l].end()), later[l].end());
    });
    return later;
}

/// Rigid bodies have one list for all of their nodes, and the first node stands for its body in those of others.
template <int Dim>
void joinBodies(const SolidDofs<Dim>& dofs, std::vector<std::vector<int>>& later) {
    if (dofs.bodies.empty()) return;
    const auto firstOf = [&](int l) { return dofs.first[dofs.node[l]]; };
    for (const auto& body : dofs.bodies) {
        auto& all = later[body.local[0]];
        for (const int l : body.local)
            if (l != body.local[0]) all.insert(all.end(), later[l].begin(), later[l].end());
    }
    for (auto& others : later) {
        for (int& l : others)
            for (const auto& body : dofs.bodies)
                if (firstOf(l) == body.first) l = body.local[0];
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        std::stable_sort(others.begin(), others.end(), [&](int a, int b) { return firstOf(a) < firstOf(b); });
    }
}

}  // namespace

template <int Dim>
SymmetricMatrix solidPattern(const PointRows<Dim>& rows, const SolidDofs<Dim>& dofs) {
    auto later = laterNodes<Dim>(rows, dofs);
    joinBodies<Dim>(dofs, later);
    std::vector<std::vector<int>> columns(dofs.n);
    for (std::size_t l = 0; l < later.size(); ++l) {
        const int first = dofs.first[dofs.node[l]], count = dofs.count[dofs.node[l]];
        if (count > 0 && !columns[first].empty()) continue;  // another node of its body came before
        for (int c = 0; c < count; ++c) {
            auto& column = columns[first + c];
            for (int d = c + 1; d < count; ++d) column.push_back(first + d);
            for (const int other : later[l])
                for (int d = 0; d < dofs.count[dofs.node[other]]; ++d)
                    column.push_back(dofs.first[dofs.node[other]] + d);
        }
    }
    return symmetricPattern(columns);
}

#define PFEM_INSTANTIATE(D) template SymmetricMatrix solidPattern<D>(const PointRows<D>&, const SolidDofs<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
