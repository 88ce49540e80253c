#include "continuity/continuitySystem.hpp"

#include <algorithm>

namespace pfem {

namespace {

/// Lower pattern: pressure graph, then interface coupling, then the solid block.
template <int Dim>
SymmetricMatrix coupledPattern(const Cells<Dim>& cells, const Topology<Dim>& topology,
                               const std::vector<int>& unknown, int nPressure, const SolidDofs<Dim>& dofs,
                               const SymmetricMatrix& solid, const NodeToNodes& ring) {
    std::vector<std::vector<int>> lower(static_cast<std::size_t>(nPressure) + solid.n);
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (unknown[i] < 0) continue;
        auto& rows = lower[unknown[i]];
        const auto addSolid = [&](int node) {
            for (int c = 0; c < dofs.count[node]; ++c) rows.push_back(nPressure + dofs.first[node] + c);
        };
        addSolid(i);
        for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) {
            if (unknown[ring.node[s]] > unknown[i]) rows.push_back(unknown[ring.node[s]]);
            addSolid(ring.node[s]);
        }
        std::sort(rows.begin(), rows.end());
    }
    for (int j = 0; j < solid.n; ++j)
        for (int s = solid.start[j] + 1; s < solid.start[j + 1]; ++s)
            lower[nPressure + j].push_back(nPressure + solid.row[s]);
    (void)cells;
    return symmetricPattern(lower);
}

/// Free-surface diagonal: the larger of scale * tau M_G and 2 |g_J|^2/(m rho Omega_J), g_J = sum_e |e| grad N_J.
template <int Dim>
void addFreeSurface(SymmetricMatrix& A, const Problem<Dim>& problem, const ContinuityControls& controls,
                    const Cells<Dim>& cells, const Topology<Dim>& topology, const Patches<Dim>& patches,
                    const std::vector<double>& tau, const Points<Dim>& x, const std::vector<int>& unknown,
                    const Newmark& newmark) {
    std::vector<double> weak(x.size(), 0.0);
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double measure = faceArea<Dim>(x, face.nodes).norm();
        const double twoOverH = 2 * measure / (Dim * patches.element[face.cell].measure);
        for (int node : face.nodes)
            weak[node] += controls.freeSurfaceScale * tau[face.cell] * twoOverH * measure / Dim;
    }
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (unknown[i] < 0 || !topology.freeSurface[i]) continue;
        Vec<Dim> g = Vec<Dim>::Zero();
        double mass = 0;
        for (int s = topology.fluid.start[i]; s < topology.fluid.start[i + 1]; ++s) {
            const int e = topology.fluid.cell[s];
            g += patches.element[e].measure * patches.element[e].gradN[topology.fluid.corner[s]];
            mass += problem.fluid(cells.material[e]).rho * patches.element[e].measure / (Dim + 1);
        }
        const double schur = 2 * controls.schurScale * g.squaredNorm() / (newmark.massFactor() * mass);
        A.add(unknown[i], unknown[i], std::max(weak[i], schur));
    }
}

}  // namespace

template <int Dim>
ContinuitySystem<Dim>::ContinuitySystem(const Problem<Dim>& problem, const ContinuityControls& controls,
                                        const Cells<Dim>& cells, const Topology<Dim>& topology,
                                        const Patches<Dim>& patches, const std::vector<double>& tau,
                                        const Points<Dim>& x, const SolidDofs<Dim>& dofs,
                                        const SymmetricMatrix& solid, const Newmark& newmark) {
    const bool strong = controls.freeSurfacePressure == "strong";
    unknown_.assign(topology.nNodes(), -1);
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.wet(i) && !(strong && topology.freeSurface[i])) unknown_[i] = nPressure_++;
    n_ = nPressure_ + solid.n;
    if (n_ == 0) return;

    const NodeToNodes ring = nodeToNodes<Dim>(cells.nodes, topology.fluid);
    SymmetricMatrix A = coupledPattern<Dim>(cells, topology, unknown_, nPressure_, dofs, solid, ring);
    for (int e = 0; e < cells.size(); ++e) {
        const Newtonian& fluid = problem.fluid(cells.material[e]);
        const auto& g = patches.element[e];
        const double laplacian = tau[e] + controls.schurScale / (fluid.rho * newmark.massFactor());
        const double compressibility = g.measure / (Dim + 1) / (fluid.kappa * newmark.dt);
        for (int k = 0; k <= Dim; ++k) {
            const int i = unknown_[cells.nodes[e][k]];
            if (i < 0) continue;
            A.add(i, i, compressibility);
            for (int l = 0; l <= Dim; ++l) {
                const int node = cells.nodes[e][l];
                const int j = unknown_[node];
                if (j >= i) A.add(i, j, laplacian * g.measure * g.gradN[k].dot(g.gradN[l]));
                const int local = dofs.local[node];
                if (local < 0) continue;
                const Vec<Dim> B = g.measure / (Dim + 1) * g.gradN[l];
                for (int c = 0; c < dofs.count[node]; ++c)
                    A.add(i, nPressure_ + dofs.first[node] + c, B.dot(dofs.basis[local].col(c)));
            }
        }
    }
    if (!strong)
        addFreeSurface<Dim>(A, problem, controls, cells, topology, patches, tau, x, unknown_, newmark);

    // without compliance the solid block stays, decoupled: divide by a tiny number instead of zero
    const double scale = 1 / std::max(controls.complianceScale, 1e-12);
    for (int j = 0; j < solid.n; ++j)
        for (int s = solid.start[j]; s < solid.start[j + 1]; ++s)
            A.add(nPressure_ + j, nPressure_ + solid.row[s], -scale * solid.value[s]);

    factor_.analyze(A);
    factor_.factorize(A);
}

template <int Dim>
std::vector<double> ContinuitySystem<Dim>::solve(const std::vector<double>& residual) const {
    std::vector<double> dp(residual.size(), 0.0);
    if (n_ == 0) return dp;
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n_);
    for (std::size_t i = 0; i < residual.size(); ++i)
        if (unknown_[i] >= 0) rhs[unknown_[i]] = -residual[i];
    const Eigen::VectorXd solution = factor_.solve(rhs);
    for (std::size_t i = 0; i < residual.size(); ++i)
        if (unknown_[i] >= 0) dp[i] = solution[unknown_[i]];
    return dp;
}

template class ContinuitySystem<2>;

}  // namespace pfem
