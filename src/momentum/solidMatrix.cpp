#include "momentum/solidMatrix.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "integration/pointRows.hpp"
#include "material/rigid.hpp"
#include "momentum/solidElementStress.hpp"
#include "momentum/solidPattern.hpp"

namespace pfem {

namespace {

/// Isotropic C = lambda I (x) I + 2 mu, times a time.
struct Moduli {
    double lambda = 0, mu = 0;  // [Pa s]
};

Moduli elastic(const Solid& m, double time) { return {time * m.elastic.lambda(), time * m.elastic.mu()}; }

/// What the strain is of the velocity's change: dt times the end-point rate, or times the mean of both ends [s].
double strainTime(const Solid& material, double dt) {
    return material.law->kinematics() == Kinematics::endPoint ? dt : 0.5 * dt;
}

Moduli operator+(const Moduli& a, const Moduli& b) { return {a.lambda + b.lambda, a.mu + b.mu}; }

/// Of stress points: their gradients and moduli, none where a body is rigid.
template <int Dim>
struct Stiffness {
    PointRows<Dim> rows;
    std::vector<std::optional<Moduli>> moduli;
};

/// `moduliOf`: of a stress point and its material.
template <int Dim, class ModuliOf>
Stiffness<Dim> stiffness(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains, const ModuliOf& moduliOf) {
    Stiffness<Dim> result{PointRows<Dim>(domains), {}};
    result.moduli.resize(nStressPoints<Dim>(domains));
    parallelFor(nStressPoints<Dim>(domains), [&](int p) {
        if (!isStressPoint<Dim>(domains, p)) return;
        const Solid& material = solidMaterial<Dim>(solids.problem, solids.cells, domains, p);
        if (!rigidOf(material.law.get())) result.moduli[p] = moduliOf(p, material);
    });
    return result;
}

/// The columns of one node after another.
template <int Dim>
class Columns {
public:
    Columns(const SolidDofs<Dim>& dofs, SymmetricMatrix& A) : dofs_(dofs), A_(A), below_(A.n, 0) {}

    /// Those of this node come next.
    void begin(int node) {
        node_ = node;
        const int column = dofs_.first[node];
        for (int s = A_.start[column]; s < A_.start[column + 1]; ++s) below_[A_.row[s]] = s - A_.start[column];
    }

    /// Add theirs of (Omega G)^T C (Omega G) / Omega.
    void add(const Moduli& moduli, const GradientRow<Dim>& row) {
        const double lambda = moduli.lambda / row.volume;
        const double mu = moduli.mu / row.volume;
        const std::size_t b = std::find(row.nodes.begin(), row.nodes.end(), node_) - row.nodes.begin();
        const Vec<Dim>& gb = row.weighted[b];
        const int nb = node_, column = dofs_.first[nb], lb = dofs_.local[nb];
        for (std::size_t a = 0; a < row.nodes.size(); ++a) {
            const int na = row.nodes[a], la = dofs_.local[na];
            if (la < 0 || dofs_.first[na] < column) continue;
            const bool same = dofs_.first[na] == column;
            const Vec<Dim>& ga = row.weighted[a];
            const Tensor<Dim> K =
                lambda * ga * gb.transpose() + mu * gb * ga.transpose() + mu * ga.dot(gb) * Tensor<Dim>::Identity();
            const int below = same ? 0 : below_[dofs_.first[na]];
            const bool free = dofs_.isFree[la] && dofs_.isFree[lb];
            for (int cb = 0; cb < dofs_.count[nb]; ++cb) {  // the rows of one node follow each other
                const int first = same ? cb : 0;
                double* const value = A_.value.data() + A_.start[column + cb] + (same ? -first : below - cb);
                for (int ca = first; ca < dofs_.count[na]; ++ca)
                    value[ca] += free ? K(ca, cb) : dofs_.basis[la].col(ca).dot(K * dofs_.basis[lb].col(cb));
            }
        }
    }

private:
    const SolidDofs<Dim>& dofs_;
    SymmetricMatrix& A_;
    std::vector<int> below_;  // per unknown: how far below the diagonal of the node's first column its row is
    int node_ = -1;
};

/// Add them all, each node's columns by one thread. All entries take their terms in the order of the stress points.
template <int Dim>
void addStiffness(const std::vector<Stiffness<Dim>>& terms, const SolidDofs<Dim>& dofs, SymmetricMatrix& A) {
    constexpr int block = 32;
    const int n = static_cast<int>(dofs.node.size());
    parallelTasks((n + block - 1) / block, [&](int k) {
        Columns<Dim> columns(dofs, A);
        for (int l = k * block; l < std::min(n, (k + 1) * block); ++l) {
            const int node = dofs.node[l];
            if (dofs.ofBody(node)) continue;
            columns.begin(node);
            for (const auto& [rows, moduli] : terms)
                for (const int p : rows.pointsOf(node))
                    if (moduli[p]) columns.add(*moduli[p], rows[p]);
        }
    });
    if (dofs.bodies.empty()) return;
    Columns<Dim> columns(dofs, A);
    for (const auto& [rows, moduli] : terms)  // a body's columns are those of many nodes
        for (std::size_t p = 0; p < moduli.size(); ++p)
            for (std::size_t b = 0; moduli[p] && b < rows[p].nodes.size(); ++b)
                if (dofs.ofBody(rows[p].nodes[b])) {
                    columns.begin(rows[p].nodes[b]);
                    columns.add(*moduli[p], rows[p]);
                }
}

/// The unknowns of a rigid body.
template <int Dim>
void addBody(const RigidBody<Dim>& body, SolidDofs<Dim>& dofs) {
    if (body.nFree() == 0) return;
    dofs.bodies.push_back({dofs.n, body.nFree(), {}});
    for (std::size_t k = 0; k < body.nodes.size(); ++k) {
        const int i = body.nodes[k];
        dofs.local[i] = static_cast<int>(dofs.node.size());
        dofs.bodies.back().local.push_back(dofs.local[i]);
        dofs.node.push_back(i);
        dofs.basis.push_back(leverRows<Dim>(body.pose.lever(body.arm[k])) * body.free);
        dofs.isFree.push_back(0);
        dofs.first[i] = dofs.n;
        dofs.count[i] = body.nFree();
    }
    dofs.n += body.nFree();
}

/// The mass of each node, in the directions of its unknowns.
template <int Dim>
void addInertia(const Points<Dim>& inertia, const SolidDofs<Dim>& dofs, SymmetricMatrix& A) {
    for (std::size_t k = 0; k < dofs.node.size(); ++k)
        for (int c = 0; c < dofs.count[dofs.node[k]]; ++c) {
            const int unknown = dofs.first[dofs.node[k]] + c;
            A.add(unknown, unknown, inertia[dofs.node[k]].dot(dofs.basis[k].col(c).cwiseAbs2()));
            if (!dofs.ofBody(dofs.node[k])) continue;
            for (int d = 0; d < c; ++d)
                A.add(unknown, dofs.first[dofs.node[k]] + d,
                      inertia[dofs.node[k]].dot(dofs.basis[k].col(c).cwiseProduct(dofs.basis[k].col(d))));
        }
}

}  // namespace

template <int Dim>
SolidDofs<Dim> solidDofs(const NodeToCells& solid, const NodeConstraints<Dim>& constraints) {
    const int n = static_cast<int>(solid.start.size()) - 1;
    SolidDofs<Dim> dofs;
    dofs.first.assign(n, -1);
    dofs.count.assign(n, 0);
    dofs.local.assign(n, -1);
    std::vector<unsigned char> ofBody(n, 0);
    for (const auto& body : constraints.bodies)
        for (const int i : body.nodes) ofBody[i] = 1;
    for (int i = 0; i < n; ++i) {
        const Freedom<Dim>& freedom = constraints.freedom[i];
        if (solid.count(i) == 0 || !freedom.any() || ofBody[i]) continue;
        dofs.local[i] = static_cast<int>(dofs.node.size());
        dofs.node.push_back(i);
        dofs.basis.push_back(freedom.basis.leftCols(freedom.count));
        dofs.isFree.push_back(freedom.count == Dim && freedom.basis.isIdentity(0));
        dofs.first[i] = dofs.n;
        dofs.count[i] = freedom.count;
        dofs.n += dofs.count[i];
    }
    for (const auto& body : constraints.bodies) addBody<Dim>(body, dofs);
    return dofs;
}

template <int Dim>
SymmetricMatrix solidMatrix(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains, const SolidDofs<Dim>& dofs,
                            const Points<Dim>& inertia, const std::vector<double>& h, const MidpointRule& midpoint) {
    if (dofs.node.empty()) return symmetricPattern({});
    const SolidControls& controls = solids.controls;
    const auto damping = [&](const Solid& material, double size) {
        return dampingTime(material, controls.damping, size);
    };
    const auto cells = pointsInCells<Dim>(domains), nodes = pointsAtNodes<Dim>(domains);
    std::vector<Stiffness<Dim>> terms;
    terms.push_back(stiffness<Dim>(solids, domains, [&](int p, const Solid& material) {
        const double tangent = strainTime(material, midpoint.dt);
        Moduli moduli = elastic(material, tangent);
        if (controls.withPressure()) moduli.lambda -= tangent * material.law->volumeModulus();
        return moduli + elastic(material, -damping(material, atPoint<Dim>(domains, h, p)));
    }));
    terms.push_back(stiffness<Dim>(solids, cells, [&](int e, const Solid& material) {
        return elastic(material, damping(material, cellMean<Dim>(domains, h, e)));
    }));
    if (controls.withPressure())
        terms.push_back(stiffness<Dim>(solids, nodes, [&](int, const Solid& material) {
            return Moduli{strainTime(material, midpoint.dt) * material.law->volumeModulus(), 0};
        }));
    SymmetricMatrix A = solidPattern<Dim>(controls.withPressure() ? terms.back().rows : terms.front().rows, dofs);
    addInertia<Dim>(inertia, dofs, A);
    addStiffness<Dim>(terms, dofs, A);
    return A;
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template SolidDofs<D> solidDofs<D>(const NodeToCells&, const NodeConstraints<D>&);                         \
    template SymmetricMatrix solidMatrix<D>(const Solids<D>&, const SmoothingDomains<D>&, const SolidDofs<D>&, \
                                            const Points<D>&, const std::vector<double>&, const MidpointRule&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
