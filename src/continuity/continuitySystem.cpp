#include "continuity/continuitySystem.hpp"

#include <algorithm>
#include <tuple>

#include "base/parallel.hpp"
#include "continuity/riderColumns.hpp"
#include "continuity/stabilisation.hpp"
#include "continuity/unknowns.hpp"
#include "linear/multigridSolver.hpp"
#include "linear/saddle.hpp"
#include "linear/solvers.hpp"
#include "momentum/fluidStress.hpp"
#include "momentum/surfaceStiffness.hpp"

namespace pfem {

namespace {

/// How many unknowns of rigid bodies a node and its neighbours have in common.
template <int Dim>
int sharedVelocities(const NodeToNodes& ring, const SolidDofs<Dim>& dofs, int i) {
    std::vector<int> firsts;
    int count = 0;
    const auto look = [&](int node) {
        if (!dofs.ofBody(node)) return;
        if (std::find(firsts.begin(), firsts.end(), dofs.first[node]) != firsts.end())
            count += dofs.count[node];
        else
            firsts.push_back(dofs.first[node]);
    };
    look(i);
    for (int s = ring.start[i]; s < ring.start[i + 1]; ++s) look(ring.node[s]);
    return count;
}

/// Where the columns start, from the neighbours in the fluid and the matrix of the solid.
template <int Dim>
std::vector<int> columnStarts(const Step<Dim>& step, const Unknowns& u, const SolidDofs<Dim>& dofs,
                              const SymmetricMatrix& solid, const RiderColumns<Dim>& riders) {
    const NodeToNodes& ring = step.topology.ring;
    const auto ownUnknowns = [&](int node) {  // where nothing rides, each node's own
        return riders.any() && dofs.local[node] >= 0 ? 0 : nVelocities<Dim>(u, dofs, node);
    };
    std::vector<int> start(u.n + 1, 1);  // the diagonals
    start[0] = 0;
    parallelFor(static_cast<int>(u.pressure.size()), [&](int i) {
        const int p = u.pressure[i];
        if (p < 0 || step.isImage(i)) return;
        int count = u.isMade[i];
        if (u.isMade[i]) {
            count += ownUnknowns(i);
            for (int s = ring.start[i]; s < ring.start[i + 1]; ++s)
                count += (u.pressure[ring.node[s]] > p) + ownUnknowns(ring.node[s]);
            if (riders.any())
                count += riders.count(ring, i);
            else if (!dofs.bodies.empty())
                count -= sharedVelocities<Dim>(ring, dofs, i);
        }
        start[p + 1] = count;
    });
    for (int j = 0; j < solid.n; ++j) start[u.nPressure + j + 1] = solid.start[j + 1] - solid.start[j];
    for (int j = 0; j < u.n; ++j) start[j + 1] += start[j];
    return start;
}

/// The columns of one pressure: its node, the neighbours in order, and the sums over the cells around it.
template <int Dim>
struct PressureColumn {
    std::vector<int> node;
    std::vector<double> K;    // laplacian and compressibility
    std::vector<Vec<Dim>> B;  // Omega_I G_IJ
    std::vector<int> at;      // per node of the mesh: its index in `node`, of the present column

    void begin(int i, const NodeToNodes& ring) {
        node.assign(ring.node.begin() + ring.start[i], ring.node.begin() + ring.start[i + 1]);
        node.insert(std::lower_bound(node.begin(), node.end(), i), i);
        for (std::size_t k = 0; k < node.size(); ++k) at[node[k]] = static_cast<int>(k);
        K.assign(node.size(), 0.0);
        B.assign(node.size(), Vec<Dim>::Zero());
    }
};

/// What the matrix is made of.
template <int Dim>
struct Parts {
    const Step<Dim>& step;
    const ContinuityControls& controls;
    const FluidPhase<Dim>& phase;
    const Stabilisation& stabilisation;
    const SolidBlock<Dim>& solid;
    const RiderColumns<Dim>& riders;
    const Unknowns& u;
};

/// The rows of a column in ascending order.
void sortRows(SymmetricMatrix& A, int column) {
    std::vector<std::pair<int, double>> entries;
    for (int s = A.start[column]; s < A.start[column + 1]; ++s) entries.emplace_back(A.row[s], A.value[s]);
    std::sort(entries.begin(), entries.end());
    for (std::size_t k = 0; k < entries.size(); ++k)
        std::tie(A.row[A.start[column] + k], A.value[A.start[column] + k]) = entries[k];
}

/// Rows and values of one pressure column, diagonal, pressures, solids, surface.
template <int Dim>
void writeColumn(const PressureColumn<Dim>& column, int i, const Parts<Dim>& parts, SymmetricMatrix& A) {
    const Unknowns& u = parts.u;
    const SolidDofs<Dim>& dofs = parts.solid.dofs;
    int s = A.start[u.pressure[i]];
    const auto put = [&](int row, double value) {
        A.row[s] = row;
        A.value[s++] = value;
    };
    for (std::size_t k = 0; k < column.node.size(); ++k)
        if (u.pressure[column.node[k]] >= u.pressure[i]) put(u.pressure[column.node[k]], column.K[k]);
    for (const bool ofSolid : {true, false}) {
        if (ofSolid && parts.riders.any()) {
            for (const auto& [unknown, value] : parts.riders.entries(i, column.node, column.B))
                put(u.nPressure + unknown, value);
            continue;
        }
        for (std::size_t k = 0; k < column.node.size(); ++k) {
            const int node = column.node[k];
            if ((dofs.local[node] >= 0) != ofSolid || dofs.ofBody(node)) continue;
            forVelocities<Dim>(u, dofs, node, [&](int unknown, const Vec<Dim>& direction) {
                put(unknown, parts.step.constraints.project(node, column.B[k]).dot(direction));
            });
        }
        if (!ofSolid) continue;
        for (const auto& body : dofs.bodies) {
            Eigen::VectorXd sum = Eigen::VectorXd::Zero(body.count);
            bool meets = false;
            for (std::size_t k = 0; k < column.node.size(); ++k) {
                const int node = column.node[k];
                if (!dofs.ofBody(node) || dofs.first[node] != body.first) continue;
                sum += dofs.basis[dofs.local[node]].transpose() * column.B[k];
                meets = true;
            }
            for (int c = 0; meets && c < body.count; ++c) put(u.nPressure + body.first + c, sum[c]);
        }
    }
    if (parts.step.images) sortRows(A, u.pressure[i]);  // those of images are out of the order of nodes
}

/// What the Laplacian of each cell counts in K_p: tau and the Schur term.
template <int Dim>
std::vector<double> laplacianWeights(const Parts<Dim>& parts) {
    const Cells<Dim>& cells = parts.phase.cells;
    std::vector<double> weights(cells.size());
    parts.phase.domains.share.forCells(cells.size(), [&](int e) {
        const double rho = parts.step.problem.fluid(cells.material[e]).rho;
        const double schur = sliverFactor<Dim>(parts.phase.domains.element[e]) * parts.step.dt() / rho;
        const double unprojected = parts.stabilisation.tau[e] + parts.controls.schurScale * schur;
        weights[e] = parts.stabilisation.projected[e] ? std::max(unprojected, schur) : unprojected;
    });
    return weights;
}

/// K_p without its face terms, and B: each pressure gathers from the cells around it. A cell that has turned over
/// counts in K_p as one that stands, so that K_p is definite: the matrix shapes the iteration alone.
template <int Dim>
void addCells(const Parts<Dim>& parts, SymmetricMatrix& A) {
    const Topology<Dim>& topology = parts.step.topology;
    const Cells<Dim>& cells = parts.phase.cells;
    const NodeToCells& around = topology.fluid;
    const double dt = parts.step.dt();
    const std::vector<double> laplacian = laplacianWeights<Dim>(parts);
#pragma omp parallel if (cells.size() > shortLoop)
    {
        PressureColumn<Dim> column;
        column.at.resize(topology.nNodes());
#pragma omp for schedule(static)
        for (int i = 0; i < topology.nNodes(); ++i) {
            if (!parts.u.isMade[i]) continue;
            column.begin(i, topology.ring);
            for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
                const int e = around.cell[s], k = around.corner[s];
                const ViscousFluid& fluid = parts.step.problem.fluid(cells.material[e]);
                const auto& g = parts.phase.domains.element[e];
                const double share = g.measure / (Dim + 1), size = std::abs(g.measure);
                for (int l = 0; l <= Dim; ++l) {
                    const int at = column.at[cells.nodes[e][l]];
                    column.K[at] += laplacian[e] * size * g.gradN[k].dot(g.gradN[l]);
                    if (l == k) column.K[at] += std::abs(share) / (fluid.kappa * dt);
                    column.B[at] += share * g.gradN[l];
                }
            }
            writeColumn<Dim>(column, i, parts, A);
        }
    }
}

/// 1/c of the solids' matrix -A/c. Without compliance the block stays, decoupled: a tiny number instead of zero.
template <int Dim>
double solidScale(const Step<Dim>& step, const ContinuityControls& controls) {
    return step.gamma() / std::max(controls.complianceScale, 1e-12);
}

/// -A/c of the solids, from column `first` on.
void addSolid(const SymmetricMatrix& solid, double scale, int first, SymmetricMatrix& A) {
    for (int j = 0; j < solid.n; ++j)
        for (int s = solid.start[j]; s < solid.start[j + 1]; ++s) {
            const int at = A.start[first + j] + s - solid.start[j];
            A.row[at] = first + solid.row[s];
            A.value[at] = -scale * solid.value[s];
        }
}

/// Weak p = 0 and the mass of the surface's velocities.
template <int Dim>
void addFreeSurface(const Parts<Dim>& parts, const Points<Dim>& x, SymmetricMatrix& A) {
    const auto& [step, controls, phase, stabilisation, solid, riders, u] = parts;
    const auto& [tau, projected] = stabilisation;
    const auto& [problem, topology, cells, domains] = std::tie(step.problem, step.topology, phase.cells, phase.domains);
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double measure = faceArea<Dim>(x, face.nodes).norm();
        const double cell = std::abs(domains.element[face.cell].measure), twoOverH = 2 * measure / (Dim * cell);
        const double tauN = surfaceStabilisation<Dim>(tau[face.cell], phase.mu[face.cell], cell, measure);
        for (int node : face.nodes)
            if (u.isMade[node] && !projected[face.cell])
                A.value[A.start[u.pressure[node]]] += controls.freeSurfaceWeight * tauN * twoOverH * measure / Dim;
    }
    const double scale = step.gamma() / std::max(controls.freeSurfaceScale, 1e-12);
    const auto stiffness = surfaceStiffness<Dim>(problem, cells, topology, x, step.midpoint);
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (u.surface[i] < 0 || step.isImage(i)) continue;
        double mass = 0;
        for (int s = topology.fluid.start[i]; s < topology.fluid.start[i + 1]; ++s) {
            const int e = topology.fluid.cell[s];
            mass += problem.fluid(cells.material[e]).rho * std::abs(domains.element[e].measure) / (Dim + 1);
        }
        const Vec<Dim> inertia = matrixInertia<Dim>(mass, stiffness[i], step.midpoint);
        for (int c = 0; c < Dim; ++c) {
            const int at = A.start[u.surface[i] + c];
            A.row[at] = u.surface[i] + c;
            A.value[at] = -scale * inertia[c];
        }
    }
}

/// Where each unknown is: at its node.
template <int Dim>
Places<Dim> placesOfUnknowns(const Step<Dim>& step, const Points<Dim>& x, const Unknowns& u,
                             const SolidDofs<Dim>& dofs) {
    Places<Dim> place(u.n);
    for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        if (step.isImage(i)) continue;
        if (u.pressure[i] >= 0) place[u.pressure[i]] = x[i];
        forVelocities<Dim>(u, dofs, i, [&](int unknown, const Vec<Dim>&) { place[unknown] = x[i]; });
    }
    return place;
}

/// Fill grows with n^1.4 in three dimensions, a multigrid's levels with n; and it takes the factor that the momentum's
/// equation has of the elastic velocities, which a direct solver computes once more, with the pressures between them.
template <int Dim>
bool byMultigrid(const ContinuityControls& controls, int nPressures, int nElastic) {
    constexpr int many = 20000, manyElastic = 1000;
    if (controls.solver != "auto") return controls.solver == "multigrid";
    return Dim == 3 && (nPressures > many || nElastic > manyElastic) && hasMultigrid();
}

/// The pressures of each rank's own nodes, or equal numbers.
RankRows rowsOfRanks(const Ranks& ranks, const Share& share, const Unknowns& u) {
    if (share.isWhole()) return {ranks, ranks.evenEnds(u.nPressure)};
    RankRows rows{ranks, {}};
    std::size_t node = 0, row = 0;
    for (const std::size_t end : share.ends()) {
        for (; node < end; ++node) row += u.pressure[node] >= 0;
        rows.ends.push_back(row);
    }
    return rows;
}

/// `places()`: where each unknown is; `elastic`: for the block of the solids; `rows`: who has which of the pressures.
template <int Dim, class PlacesOf>
std::unique_ptr<SymmetricSolver> makeSolver(const ContinuityControls& controls, const SymmetricMatrix& A,
                                            const PlacesOf& places, const SaddleSizes& sizes, ElasticInverse elastic,
                                            RankRows rows) {
    if (byMultigrid<Dim>(controls, sizes.nPressures, sizes.nElastic))
        return std::make_unique<MultigridSolver>(sizes, std::move(elastic), controls.solverTolerance, std::move(rows));
    const auto precision = controls.factorPrecision == "double" ? Precision::twofold : Precision::single;
    return dissectedSolver<Dim>(A, places(), precision);
}

}  // namespace

template <int Dim>
bool hasOwnRows(const Step<Dim>& step, const ContinuityControls& controls) {
    if (step.images || step.mesh.solid.size() > 0 || !step.constraints.bodies.empty() ||
        !step.constraints.riders.empty() || !isNewtonian<Dim>(step.problem))
        return false;  // whatever takes more than the cells around a node's neighbours
    const bool strong = controls.freeSurfacePressure == "strong";
    return byMultigrid<Dim>(controls, numberUnknowns<Dim>(step, {}, strong, 0).nPressure, 0);
}

template <int Dim>
ContinuitySystem<Dim>::ContinuitySystem(const Step<Dim>& step, const ContinuityControls& controls,
                                        const FluidPhase<Dim>& fluid, const Stabilisation& stabilisation,
                                        const Points<Dim>& x, const SolidBlock<Dim>& solid) {
    const bool strong = controls.freeSurfacePressure == "strong";
    const Unknowns u = numberUnknowns<Dim>(step, fluid.domains.share, strong, solid.matrix.n);
    unknown_ = u.pressure;
    nOwn_ = step.images ? step.images->nOwn : step.topology.nNodes();
    n_ = u.n;
    nPressures_ = u.nPressure;
    if (n_ == 0) return;

    const RiderColumns<Dim> riders(step, solid.dofs, x);
    const Parts<Dim> of{step, controls, fluid, stabilisation, solid, riders, u};
    SymmetricMatrix A;
    A.n = u.n;
    const SymmetricMatrix diagonal =
        byMultigrid<Dim>(controls, u.nPressure, u.nSolid) ? diagonalOf(solid.matrix) : SymmetricMatrix();
    const SymmetricMatrix& elastic = diagonal.n > 0 ? diagonal : solid.matrix;  // a multigrid asks for no more
    A.start = columnStarts<Dim>(step, u, solid.dofs, elastic, riders);
    A.row.resize(A.start[u.n]);
    A.value.resize(A.start[u.n]);
    addCells<Dim>(of, A);
    addSolid(elastic, solidScale<Dim>(step, controls), u.nPressure, A);
    if (!strong) addFreeSurface<Dim>(of, x, A);

    const auto places = [&] { return placesOfUnknowns<Dim>(step, x, u, solid.dofs); };
    solver_ =
        makeSolver<Dim>(controls, A, places, {u.nPressure, u.nSolid}, {solid.factor, solidScale<Dim>(step, controls)},
                        rowsOfRanks(controls.ranks, fluid.domains.share, u));
    solver_->analyse(A);
    solver_->factor(A);
}

template <int Dim>
std::vector<double> ContinuitySystem<Dim>::solve(const std::vector<double>& residual) const {
    std::vector<double> dp(residual.size(), 0.0);
    if (n_ == 0) return dp;
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(nPressures_);
    parallelFor(nOwn_, [&](int i) {
        if (unknown_[i] >= 0) rhs[unknown_[i]] = -residual[i];
    });
    const Eigen::VectorXd solution = solver_->solveFirst(rhs, n_);
    parallelFor(static_cast<int>(residual.size()), [&](int i) {
        if (unknown_[i] >= 0) dp[i] = solution[unknown_[i]];
    });
    return dp;
}

#define PFEM_INSTANTIATE(D)                                                 \
    template bool hasOwnRows<D>(const Step<D>&, const ContinuityControls&); \
    template class ContinuitySystem<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
