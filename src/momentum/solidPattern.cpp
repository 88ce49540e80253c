#include "momentum/solidPattern.hpp"

#include <algorithm>

namespace pfem {

namespace {

/// Per node of the unknowns those that come after it and share a stress point with it, ascending.
template <int Dim>
std::vector<std::vector<int>> laterNodes(const PointRows<Dim>& rows, const SolidDofs<Dim>& dofs) {
    std::vector<std::vector<int>> later(dofs.node.size());
    parallelFor(
        static_cast<int>(later.size()),
        [&](int l) {
            const int node = dofs.node[l];
            for (const int p : rows.pointsOf(node))
                for (const int other : rows[p].nodes)
                    if (dofs.local[other] >= 0 && dofs.first[other] > dofs.first[node])
                        later[l].push_back(dofs.local[other]);
            std::sort(later[l].begin(), later[l].end());
            later[l].erase(std::unique(later[l].begin(), later[l].end()), later[l].end());
        },
        shortLongLoop);
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
    std::vector<unsigned char> hasColumns(later.size(), 1);  // one node of a body has those of the body
    for (const auto& body : dofs.bodies)
        for (const int l : body.local) hasColumns[l] = l == body.local[0];
    const auto nUnknowns = [&](int l) { return dofs.count[dofs.node[l]]; };
    SymmetricMatrix A;
    A.n = dofs.n;
    A.start.assign(dofs.n + 1, 0);
    for (std::size_t l = 0; l < later.size(); ++l) {
        if (!hasColumns[l]) continue;
        int below = 0;
        for (const int other : later[l]) below += nUnknowns(other);
        const int first = dofs.first[dofs.node[l]], count = nUnknowns(static_cast<int>(l));
        for (int c = 0; c < count; ++c) A.start[first + c + 1] = count - c + below;
    }
    for (int j = 0; j < A.n; ++j) A.start[j + 1] += A.start[j];
    A.row.resize(A.start[A.n]);
    A.value.assign(A.start[A.n], 0.0);
    parallelFor(
        static_cast<int>(later.size()),
        [&](int l) {
            if (!hasColumns[l]) return;
            const int first = dofs.first[dofs.node[l]], count = nUnknowns(l);
            for (int c = 0; c < count; ++c) {
                int s = A.start[first + c];
                for (int d = c; d < count; ++d) A.row[s++] = first + d;
                for (const int other : later[l])
                    for (int d = 0; d < nUnknowns(other); ++d) A.row[s++] = dofs.first[dofs.node[other]] + d;
            }
        },
        shortLongLoop);
    return A;
}

#define PFEM_INSTANTIATE(D) template SymmetricMatrix solidPattern<D>(const PointRows<D>&, const SolidDofs<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
