#include "momentum/solidMatrix.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "integration/gradientRow.hpp"
#include "material/rigid.hpp"
#include "momentum/solidElementStress.hpp"

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

/// Add (Omega G)^T C (Omega G) / Omega.
template <int Dim>
void addStiffness(SymmetricMatrix& A, const SolidDofs<Dim>& dofs, const Moduli& moduli, const GradientRow<Dim>& row) {
    const double lambda = moduli.lambda / row.volume;
    const double mu = moduli.mu / row.volume;
    for (std::size_t b = 0; b < row.nodes.size(); ++b)
        for (std::size_t a = 0; a < row.nodes.size(); ++a) {
            const int na = row.nodes[a], nb = row.nodes[b];
            const int la = dofs.local[na], lb = dofs.local[nb];
            if (la < 0 || lb < 0 || dofs.first[na] < dofs.first[nb]) continue;
            const Vec<Dim>& ga = row.weighted[a];
            const Vec<Dim>& gb = row.weighted[b];
            const Tensor<Dim> K =
                lambda * ga * gb.transpose() + mu * gb * ga.transpose() + mu * ga.dot(gb) * Tensor<Dim>::Identity();
            for (int cb = 0; cb < dofs.count[nb]; ++cb) {
                const int first = dofs.first[na] == dofs.first[nb] ? cb : 0;  // rows of one node follow each other
                const int slot = A.slot(dofs.first[na] + first, dofs.first[nb] + cb);
                for (int ca = first; ca < dofs.count[na]; ++ca)
                    A.value[slot + ca - first] += dofs.basis[la].col(ca).dot(K * dofs.basis[lb].col(cb));
            }
        }
}

/// Pattern: nodes that share a stress point (nodal domains: two rings of the mesh).
template <int Dim>
SymmetricMatrix emptySolidMatrix(const SmoothingDomains<Dim>& domains, const SolidDofs<Dim>& dofs) {
    std::vector<std::vector<int>> lower(dofs.node.size());  // by local nodes
    for (int p = 0; p < nStressPoints<Dim>(domains); ++p) {
        if (!isStressPoint<Dim>(domains, p)) continue;
        const GradientRow<Dim> row = pointRow<Dim>(domains, p);
        for (int a : row.nodes)
            for (int b : row.nodes)
                if (dofs.local[b] >= 0 && dofs.local[a] >= 0 && dofs.first[a] > dofs.first[b])
                    lower[dofs.local[b]].push_back(dofs.local[a]);
    }
    std::vector<std::vector<int>> rows(dofs.n);
    const auto firstOf = [&](int l) { return dofs.first[dofs.node[l]]; };
    for (const auto& body : dofs.bodies) {  // one list for all nodes of the body
        auto& all = lower[body.local[0]];
        for (const int l : body.local)
            if (l != body.local[0]) all.insert(all.end(), lower[l].begin(), lower[l].end());
    }
    for (auto& others : lower)
        for (int& l : others)  // the first node stands for its body
            for (const auto& body : dofs.bodies)
                if (firstOf(l) == body.first) l = body.local[0];
    for (std::size_t l = 0; l < lower.size(); ++l) {
        std::sort(lower[l].begin(), lower[l].end());
        lower[l].erase(std::unique(lower[l].begin(), lower[l].end()), lower[l].end());
        if (!dofs.bodies.empty())
            std::stable_sort(lower[l].begin(), lower[l].end(), [&](int a, int b) { return firstOf(a) < firstOf(b); });
        const int first = dofs.first[dofs.node[l]], count = dofs.count[dofs.node[l]];
        if (count > 0 && !rows[first].empty()) continue;  // another node of its body came before
        for (int c = 0; c < count; ++c) {
            auto& column = rows[first + c];
            for (int d = c + 1; d < count; ++d) column.push_back(first + d);
            for (int other : lower[l])
                for (int d = 0; d < dofs.count[dofs.node[other]]; ++d)
                    column.push_back(dofs.first[dofs.node[other]] + d);
        }
    }
    return symmetricPattern(rows);
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
        dofs.first[i] = dofs.n;
        dofs.count[i] = body.nFree();
    }
    dofs.n += body.nFree();
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
    const auto& [problem, controls, cells] = solids;
    const bool withPressure = controls.withPressure();
    SymmetricMatrix A = emptySolidMatrix<Dim>(withPressure ? withNodalPoints<Dim>(domains) : domains, dofs);
    for (std::size_t k = 0; k < dofs.node.size(); ++k)
        for (int c = 0; c < dofs.count[dofs.node[k]]; ++c) {
            const int unknown = dofs.first[dofs.node[k]] + c;
            A.add(unknown, unknown, inertia[dofs.node[k]].dot(dofs.basis[k].col(c).cwiseAbs2()));
            if (!dofs.ofBody(dofs.node[k])) continue;
            for (int d = 0; d < c; ++d)
                A.add(unknown, dofs.first[dofs.node[k]] + d,
                      inertia[dofs.node[k]].dot(dofs.basis[k].col(c).cwiseProduct(dofs.basis[k].col(d))));
        }

    for (int p = 0; p < nStressPoints<Dim>(domains); ++p) {
        if (!isStressPoint<Dim>(domains, p)) continue;
        const Solid& material = solidMaterial<Dim>(problem, cells, domains, p);
        if (!dofs.bodies.empty() && rigidOf(material.law.get())) continue;
        const double tangent = strainTime(material, midpoint.dt);
        const auto row = pointRow<Dim>(domains, p);
        Moduli moduli = elastic(material, tangent);
        if (withPressure) moduli.lambda -= tangent * material.law->volumeModulus();
        const double tau = dampingTime(material, controls.damping, atPoint<Dim>(domains, h, p));
        addStiffness<Dim>(A, dofs, moduli + elastic(material, -tau), row);
    }
    for (int e = 0; e < domains.nCells(); ++e) {
        const Solid& material = problem.solid(cells.material[e]);
        if (!dofs.bodies.empty() && rigidOf(material.law.get())) continue;
        const double tau = dampingTime(material, controls.damping, cellMean<Dim>(domains, h, e));
        addStiffness<Dim>(A, dofs, elastic(material, tau), elementRow<Dim>(domains, e));
    }
    if (!withPressure) return A;
    const auto atNodes = withNodalPoints<Dim>(domains);
    for (int i = 0; i < atNodes.nNodes(); ++i)
        if (isStressPoint<Dim>(atNodes, i)) {
            const Solid& material = solidMaterial<Dim>(problem, cells, atNodes, i);
            const double modulus = strainTime(material, midpoint.dt) * material.law->volumeModulus();
            addStiffness<Dim>(A, dofs, {modulus, 0}, pointRow<Dim>(atNodes, i));
        }
    return A;
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template SolidDofs<D> solidDofs<D>(const NodeToCells&, const NodeConstraints<D>&);                         \
    template SymmetricMatrix solidMatrix<D>(const Solids<D>&, const SmoothingDomains<D>&, const SolidDofs<D>&, \
                                            const Points<D>&, const std::vector<double>&, const MidpointRule&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
