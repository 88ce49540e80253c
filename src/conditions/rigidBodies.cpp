#include "conditions/rigidBodies.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/spectrum.hpp"
#include "material/rigid.hpp"
#include "mesh/components.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

const Rigid* rigidOf(const Material& m) {
    return m.kind == MaterialKind::solid ? pfem::rigidOf(m.solid.law.get()) : nullptr;
}

/// Rigid cells that hang together by nodes, each group by the cells' indices; in the order of their first cells.
template <int Dim>
std::vector<std::vector<int>> groupsOfCells(const Problem<Dim>& problem, const Cells<Dim>& cells, int nNodes) {
    std::vector<int> rigid;
    std::vector<Simplex<Dim>> nodes;
    for (int e = 0; e < cells.size(); ++e) {
        if (!rigidOf(problem.materials[cells.material[e]])) continue;
        rigid.push_back(e);
        nodes.push_back(cells.nodes[e]);
    }
    const auto root = components(nodes, nNodes);
    std::map<int, std::size_t> groupOf;
    std::vector<std::vector<int>> groups;
    for (const int e : rigid) {
        const auto [group, isNew] = groupOf.emplace(root[cells.nodes[e][0]], groups.size());
        if (isNew) groups.emplace_back();
        groups[group->second].push_back(e);
    }
    return groups;
}

/// A given place, else another.
template <int Dim>
Vec<Dim> placeOr(const std::vector<double>& given, const Vec<Dim>& other) {
    return given.empty() ? other : Vec<Dim>(Eigen::Map<const Eigen::Vector3d>(given.data()).head<Dim>());
}

/// Mass, centre of mass (a place of the reference state) and inertia about it, of the mesh or as given.
template <int Dim>
void setMass(const Rigid& law, double rho, const Cells<Dim>& cells, const std::vector<int>& group, const Points<Dim>& X,
             RigidBody<Dim>& body) {
    double volume = 0;
    Vec<Dim> moment = Vec<Dim>::Zero();
    for (const int e : group) {
        const double own = simplexMeasure<Dim>(X, cells.nodes[e]);
        volume += own;
        moment += own * simplexCentroid<Dim>(X, cells.nodes[e]);
    }
    body.mass = law.mass > 0 ? law.mass : rho * volume;
    body.centre = placeOr<Dim>(law.centreOfMass, moment / volume);
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // int r r^T dV
    for (const int e : group) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        Tensor<Dim> squares = Tensor<Dim>::Zero();
        for (const int node : cells.nodes[e]) {
            const Vec<Dim> r = X[node] - body.centre;
            sum += r;
            squares += r * r.transpose();
        }
        second.topLeftCorner<Dim, Dim>() +=
            simplexMeasure<Dim>(X, cells.nodes[e]) / ((Dim + 1) * (Dim + 2)) * (squares + sum * sum.transpose());
    }
    body.inertia = body.mass / volume * (second.trace() * Eigen::Matrix3d::Identity() - second);
    if (!law.momentOfInertia.empty())
        body.inertia = Eigen::Map<const Eigen::Vector3d>(law.momentOfInertia.data()).asDiagonal();
}

/// The pose that brings the reference positions nearest to the present ones; arms of nodes are set.
template <int Dim>
void setPose(const Vec<Dim>& reference, const Nodes<Dim>& nodes, RigidBody<Dim>& body) {
    Vec<Dim> meanX = Vec<Dim>::Zero(), mean = Vec<Dim>::Zero();
    const auto n = static_cast<double>(body.nodes.size());
    for (const int i : body.nodes) {
        meanX += nodes.X[i] / n;
        mean += nodes.x[i] / n;
        body.arm.push_back(nodes.X[i] - reference);
    }
    Tensor<Dim> H = Tensor<Dim>::Zero();
    for (const int i : body.nodes) H += (nodes.x[i] - mean) * (nodes.X[i] - meanX).transpose();
    if constexpr (Dim == 2) {
        const Vec<2> turn = Vec<2>(H(0, 0) + H(1, 1), H(1, 0) - H(0, 1)).normalized();
        body.pose.turn << turn[0], -turn[1], turn[1], turn[0];
    } else {
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
        body.pose.turn = svd.matrixU() * Vec<3>(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
    }
    body.pose.at = mean + body.pose.turn * (reference - meanX);
}

/// Rows whose product with the twist vanishes, summed up as rows^T rows; turning times the body's size.
template <int Dim>
struct HeldMotions {
    double size;
    TwistMatrix<Dim> sum = TwistMatrix<Dim>::Zero();

    void add(Twist<Dim> row) {
        row.template tail<nTwist<Dim> - Dim>() /= size;
        sum += row * row.transpose();
    }
    /// No motion along n at the lever r.
    void addAt(const Vec<Dim>& r, const Vec<Dim>& n) { add(leverRows<Dim>(r).transpose() * n); }
    /// No turning about n.
    void addTurn(const Eigen::Vector3d& n) {
        Twist<Dim> row = Twist<Dim>::Zero();
        if constexpr (Dim == 2)
            row[2] = n[2] * size;
        else
            row.template tail<3>() = n * size;
        add(row);
    }
    /// The motions that are left.
    void free(RigidBody<Dim>& body) const {
        body.free = TwistMatrix<Dim>::Identity();
        if (sum.isZero(0)) return;
        const auto eigen = spectrum<nTwist<Dim>>(sum);
        int n = 0;
        while (n < nTwist<Dim> && eigen.values[n] < 1e-9 * eigen.values.maxCoeff()) ++n;
        body.free = eigen.vectors.leftCols(n);
        const Twist<Dim> twist = body.twist;
        body.twist.setZero();
        Twist<Dim> scaled = twist;
        scaled.template tail<nTwist<Dim> - Dim>() *= size;
        const Eigen::VectorXd kept = body.free.transpose() * scaled;
        if (n > 0) body.twist = body.free * kept;
        body.twist.template tail<nTwist<Dim> - Dim>() /= size;
        body.free.template bottomRows<nTwist<Dim> - Dim>() /= size;
    }
};

/// What the material's constraints hold.
template <int Dim>
void holdByMaterial(const Rigid& law, HeldMotions<Dim>& held) {
    using Type = RigidConstraint::Type;
    const Vec<Dim> at = Vec<Dim>::Zero();
    for (const auto& c : law.constraints) {
        const Eigen::Vector3d& d = c.direction;
        const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
        if (c.type == Type::plane) held.addAt(at, Vec<Dim>(d.head<Dim>()));
        for (int k = 0; k < 3; ++k) {
            if ((c.type == Type::point || c.type == Type::line) && k < Dim)
                held.addAt(at, Vec<Dim>((c.type == Type::point ? Eigen::Vector3d(Eigen::Vector3d::Unit(k))
                                                               : Eigen::Vector3d(across.col(k)))
                                            .template head<Dim>()));
            if (c.type == Type::orientation) held.addTurn(Eigen::Vector3d::Unit(k));
            if (c.type == Type::axis) held.addTurn(across.col(k));
        }
    }
}

template <int Dim>
bool alike(const RigidStep<Dim>& a, const RigidStep<Dim>& b) {
    return a.rotation == b.rotation && a.from == b.from && a.to == b.to && a.velocity == b.velocity && a.spin == b.spin;
}

/// What patches hold: rows of the body's constraints, or a motion that it follows. Its nodes are free then.
template <int Dim>
void holdByPatches(const std::string& name, NodeConstraints<Dim>& constraints, HeldMotions<Dim>& held,
                   RigidBody<Dim>& body) {
    int motion = -1;
    for (std::size_t k = 0; k < body.nodes.size(); ++k) {
        const int i = body.nodes[k];
        Freedom<Dim>& freedom = constraints.freedom[i];
        if (freedom.all()) continue;
        if (constraints.isMoved(i)) {
            const auto& part = constraints.following[constraints.followed[i]].part[0];
            const auto& moves = constraints.motion;
            if (freedom.any() || (motion >= 0 && !alike<Dim>(moves[motion], moves[part.motion])))
                throw UserError(
                    "the rigid body of material '" + name +
                    "' is held by two patches that move: a clamped patch with 'motion' moves it as a whole");
            motion = part.motion;
        }
        for (int c = 0; c < Dim; ++c) {
            const Vec<Dim> n = Vec<Dim>::Unit(c) - freedom.project(Vec<Dim>::Unit(c));
            held.addAt(body.pose.lever(body.arm[k]), n);
        }
        freedom = {};
        constraints.followed[i] = -1;
    }
    if (motion >= 0) body.follows = constraints.motion[motion];
}

/// Body by body: what is given for a body as a whole cannot be of several.
template <int Dim>
void demandOneBody(const std::vector<RigidBody<Dim>>& bodies, const Problem<Dim>& problem) {
    std::map<int, int> count;
    for (const auto& body : bodies) {
        const Rigid& law = *rigidOf(problem.materials[body.material]);
        if (++count[body.material] < 2 || (law.mass == 0 && law.momentOfInertia.empty() && law.centreOfMass.empty() &&
                                           law.centreOfRotation.empty() && law.restraints.empty()))
            continue;
        throw UserError("several bodies are of the rigid material '" + problem.materials[body.material].name +
                        "', whose mass, inertia, centres or restraints are given: each needs a material of its own");
    }
}

}  // namespace

template <int Dim>
bool hasRigidBodies(const Problem<Dim>& problem) {
    return std::any_of(problem.materials.begin(), problem.materials.end(),
                       [](const Material& m) { return rigidOf(m) != nullptr; });
}

template <int Dim>
void addRigidBodies(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const Nodes<Dim>& nodes,
                    NodeConstraints<Dim>& constraints) {
    if (!hasRigidBodies<Dim>(problem)) return;
    for (const auto& group : groupsOfCells<Dim>(problem, mesh.solid, nodes.size())) {
        RigidBody<Dim> body;
        body.material = mesh.solid.material[group[0]];
        const Material& material = problem.materials[body.material];
        const Rigid& law = *rigidOf(material);
        for (const int e : group)
            body.nodes.insert(body.nodes.end(), mesh.solid.nodes[e].begin(), mesh.solid.nodes[e].end());
        std::sort(body.nodes.begin(), body.nodes.end());
        body.nodes.erase(std::unique(body.nodes.begin(), body.nodes.end()), body.nodes.end());
        setMass<Dim>(law, material.solid.rho, mesh.solid, group, nodes.X, body);
        const Vec<Dim> reference = placeOr<Dim>(law.centreOfRotation, body.centre);
        body.centre -= reference;
        setPose<Dim>(reference, nodes, body);
        body.restraints = &law.restraints;
        Points<Dim> levers, velocities;
        double size = 0;
        for (std::size_t k = 0; k < body.nodes.size(); ++k) {
            levers.push_back(body.pose.lever(body.arm[k]));
            velocities.push_back(nodes.v[body.nodes[k]]);
            size = std::max(size, levers.back().norm());
        }
        body.twist = nearestTwist<Dim>(levers, velocities);
        HeldMotions<Dim> held{size};
        holdByMaterial<Dim>(law, held);
        holdByPatches<Dim>(material.name, constraints, held, body);
        held.free(body);
        if (body.nFree() == 0 && !body.follows) body.follows = RigidStep<Dim>();
        if (body.follows) body.free.resize(Eigen::NoChange, 0);
        constraints.bodies.push_back(std::move(body));
    }
    demandOneBody<Dim>(constraints.bodies, problem);
}

template <int Dim>
std::vector<RigidBody<Dim>> rigidBodies(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const Nodes<Dim>& nodes) {
    NodeConstraints<Dim> nothing;
    nothing.freedom.assign(nodes.id.size(), {});
    nothing.followed.assign(nodes.id.size(), -1);
    addRigidBodies<Dim>(problem, mesh, nodes, nothing);
    return std::move(nothing.bodies);
}

#define PFEM_INSTANTIATE(D)                                                                                \
    template std::vector<RigidBody<D>> rigidBodies<D>(const Problem<D>&, const Mesh<D>&, const Nodes<D>&); \
    template bool hasRigidBodies<D>(const Problem<D>&);                                                    \
    template void addRigidBodies<D>(const Problem<D>&, const Mesh<D>&, const Nodes<D>&, NodeConstraints<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
