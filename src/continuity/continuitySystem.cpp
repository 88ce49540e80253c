#include "continuity/continuitySystem.hpp"

#include <algorithm>

namespace pfem {

namespace {

/// Numbering of the coupled matrix: pressures, solid velocities, velocities of free-surface nodes.
struct Unknowns {
    std::vector<int> pressure;  // per node: its pressure unknown or -1
    std::vector<int> surface;   // per node: first velocity unknown of a moving free-surface node or -1
    int nPressure = 0;
    int nSolid = 0;
    int n = 0;
};

template <int Dim>
Unknowns numberUnknowns(const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, bool strong,
                        int nSolid) {
    Unknowns u;
    u.pressure.assign(topology.nNodes(), -1);
    u.surface.assign(topology.nNodes(), -1);
    u.nSolid = nSolid;
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.wet(i) && !(strong && topology.freeSurface[i])) u.pressure[i] = u.nPressure++;
    u.n = u.nPressure + nSolid;
    if (strong) return u;
    for (int i = 0; i < topology.nNodes(); ++i) {
        const bool moves = constraints.hold[i] == Hold::free || constraints.hold[i] == Hold::slide;
        if (!topology.freeSurface[i] || topology.onSolid[i] || !moves) continue;
        u.surface[i] = u.n;
        u.n += Dim;
    }
    return u;
}

/// Visit the velocity unknowns of a node: visit(unknown, direction).
template <int Dim, class Visitor>
void forVelocities(const Unknowns& u, const SolidDofs<Dim>& solid, int node, Visitor&& visit) {
    if (solid.local[node] >= 0)
        for (int c = 0; c < solid.count[node]; ++c)
            visit(u.nPressure + solid.first[node] + c, Vec<Dim>(solid.basis[solid.local[node]].col(c)));
    else if (u.surface[node] >= 0)
        for (int c = 0; c < Dim; ++c) visit(u.surface[node] + c, Vec<Dim>(Vec<Dim>::Unit(c)));
}

template <int Dim>
SymmetricMatrix coupledPattern(const Cells<Dim>& cells, const Topology<Dim>& topology, const Unknowns& u,
                               const SolidDofs<Dim>& dofs, const SymmetricMatrix& solid) {
    const NodeToNodes ring = nodeToNodes<Dim>(cells.nodes, topology.fluid);
    std::vector<std::vector<int>> lower(u.n);
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (u.pressure[i] < 0) continue;
        auto& rows = lower[u.pressure[i]];
        const auto addVelocities = [&](int node) {
            forVelocities<Dim>(u, dofs, node, [&](int unknown, const Vec<Dim>&) { rows.push_back(unknown); });
        };
        addVelocities(i);
        for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) {
            if (u.pressure[ring.node[s]] > u.pressure[i]) rows.push_back(u.pressure[ring.node[s]]);
            addVelocities(ring.node[s]);
        }
        std::sort(rows.begin(), rows.end());
    }
    for (int j = 0; j < solid.n; ++j)
        for (int s = solid.start[j] + 1; s < solid.start[j + 1]; ++s)
            lower[u.nPressure + j].push_back(u.nPressure + solid.row[s]);
    return symmetricPattern(lower);
}

/// K_p without its face terms, and B.
template <int Dim>
void addCells(SymmetricMatrix& A, const Problem<Dim>& problem, const ContinuityControls& controls,
              const Cells<Dim>& cells, const Patches<Dim>& patches, const std::vector<double>& tau, const Unknowns& u,
              const SolidDofs<Dim>& dofs, const NodeConstraints<Dim>& constraints, const Newmark& newmark) {
    for (int e = 0; e < cells.size(); ++e) {
        const Newtonian& fluid = problem.fluid(cells.material[e]);
        const auto& g = patches.element[e];
        const double laplacian = tau[e] + controls.schurScale / (fluid.rho * newmark.massFactor());
        const double share = g.measure / (Dim + 1);
        for (int k = 0; k <= Dim; ++k) {
            const int i = u.pressure[cells.nodes[e][k]];
            if (i < 0) continue;
            A.add(i, i, share / (fluid.kappa * newmark.dt));
            for (int l = 0; l <= Dim; ++l) {
                const int node = cells.nodes[e][l];
                const int j = u.pressure[node];
                if (j >= i) A.add(i, j, laplacian * g.measure * g.gradN[k].dot(g.gradN[l]));
                const Vec<Dim> B = share * constraints.project(node, g.gradN[l]);
                forVelocities<Dim>(u, dofs, node, [&](int unknown, const Vec<Dim>& direction) {
                    A.add(i, unknown, B.dot(direction));
                });
            }
        }
    }
}

template <int Dim>
void addFreeSurface(SymmetricMatrix& A, const Problem<Dim>& problem, const ContinuityControls& controls,
                    const Cells<Dim>& cells, const Topology<Dim>& topology, const Patches<Dim>& patches,
                    const std::vector<double>& tau, const Points<Dim>& x, const Unknowns& u,
                    const Newmark& newmark) {
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double measure = faceArea<Dim>(x, face.nodes).norm();
        const double twoOverH = 2 * measure / (Dim * patches.element[face.cell].measure);
        for (int node : face.nodes)
            if (u.pressure[node] >= 0)
                A.add(u.pressure[node], u.pressure[node],
                      controls.freeSurfaceWeight * tau[face.cell] * twoOverH * measure / Dim);
    }
    const double scale = 1 / std::max(controls.freeSurfaceScale, 1e-12);
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (u.surface[i] < 0) continue;
        double mass = 0;
        for (int s = topology.fluid.start[i]; s < topology.fluid.start[i + 1]; ++s) {
            const int e = topology.fluid.cell[s];
            mass += problem.fluid(cells.material[e]).rho * patches.element[e].measure / (Dim + 1);
        }
        for (int c = 0; c < Dim; ++c) A.add(u.surface[i] + c, u.surface[i] + c, -scale * newmark.massFactor() * mass);
    }
}

}  // namespace

template <int Dim>
ContinuitySystem<Dim>::ContinuitySystem(const Problem<Dim>& problem, const ContinuityControls& controls,
                                        const Cells<Dim>& cells, const Topology<Dim>& topology,
                                        const NodeConstraints<Dim>& constraints, const Patches<Dim>& patches,
                                        const std::vector<double>& tau, const Points<Dim>& x,
                                        const SolidDofs<Dim>& dofs, const SymmetricMatrix& solid,
                                        const Newmark& newmark) {
    const bool strong = controls.freeSurfacePressure == "strong";
    const Unknowns u = numberUnknowns<Dim>(topology, constraints, strong, solid.n);
    unknown_ = u.pressure;
    n_ = u.n;
    if (n_ == 0) return;

    SymmetricMatrix A = coupledPattern<Dim>(cells, topology, u, dofs, solid);
    addCells<Dim>(A, problem, controls, cells, patches, tau, u, dofs, constraints, newmark);
    if (!strong) addFreeSurface<Dim>(A, problem, controls, cells, topology, patches, tau, x, u, newmark);
    // without compliance the solid block stays, decoupled: divide by a tiny number instead of zero
    const double scale = 1 / std::max(controls.complianceScale, 1e-12);
    for (int j = 0; j < solid.n; ++j)
        for (int s = solid.start[j]; s < solid.start[j + 1]; ++s)
            A.add(u.nPressure + j, u.nPressure + solid.row[s], -scale * solid.value[s]);

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
