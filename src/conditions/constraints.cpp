#include "conditions/constraints.hpp"

#include <Eigen/LU>
#include <cmath>

#include "conditions/givingWay.hpp"
#include "conditions/inflow.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// Directions in which a node is held, and by what.
template <int Dim>
class Hold {
public:
    /// Hold motion along n, unless it is held already; `motion`: that it follows, -1: none; `ride`: that it goes along
    /// with.
    void along(const Vec<Dim>& n, int motion, int ride = -1) {
        const Freedom<Dim> less = freedom_.without(n);
        if (less.count == freedom_.count) return;
        freedom_ = less;
        following_.part[following_.count++] = {n.normalized(), Vec<Dim>::Zero(), motion, ride};
        moves_ = moves_ || motion >= 0 || ride >= 0;
    }
    /// Hold what is still free.
    void wholly(int motion) {
        const Freedom<Dim> free = freedom_;
        for (int c = 0; c < free.count; ++c) along(free.basis.col(c), motion);
    }

    const Freedom<Dim>& freedom() const { return freedom_; }
    bool moves() const { return moves_; }

    /// N (N^T N)^-1 of the normals N: the duals.
    Following<Dim> following() const {
        Following<Dim> f = following_;
        Eigen::Matrix<double, Dim, Eigen::Dynamic, 0, Dim, Dim> N(Dim, f.count);
        for (int k = 0; k < f.count; ++k) N.col(k) = f.part[k].normal;
        const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Dim, Dim> metric = N.transpose() * N;
        const Eigen::Matrix<double, Dim, Eigen::Dynamic, 0, Dim, Dim> dual = N * metric.inverse();
        for (int k = 0; k < f.count; ++k) f.part[k].dual = dual.col(k);
        return f;
    }

private:
    Freedom<Dim> freedom_;
    Following<Dim> following_;
    bool moves_ = false;
};

/// Mean normals of the faces that a node belongs to: one of all those that differ by less than 20 degrees.
template <int Dim>
struct NormalCollector {
    std::vector<std::array<Vec<Dim>, Dim>> sum;

    explicit NormalCollector(std::size_t n) : sum(n) {
        for (auto& normals : sum) normals.fill(Vec<Dim>::Zero());
    }
    void add(int node, const Vec<Dim>& n) {
        for (auto& normal : sum[node]) {
            if (normal.squaredNorm() > 0 && normal.normalized().dot(n) < std::cos(featureAngle * M_PI / 180)) continue;
            normal += n;
            return;
        }
    }
};

/// The motion of nodes at inlets, after those of the patches: per node its number, -1: none, and whether it is pinned.
struct Driven {
    int motion = -1;
    bool pinned = false;
};

template <int Dim>
std::vector<Driven> addDriven(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology,
                              const Nodes<Dim>& nodes, double t0, double t1, std::vector<RigidStep<Dim>>& motions) {
    std::vector<Driven> by(nodes.x.size());
    for (const auto& [node, motion, pinned] : inflowOf<Dim>(conditions, topology, nodes.x, nodes, t0, t1).driven) {
        by[node] = {static_cast<int>(motions.size()), pinned};
        motions.push_back(motion);
    }
    return by;
}

/// At an inlet a node goes with the prescribed velocity, at the free surface across the patch only; an outlet that
/// guides the water takes what is along it.
template <int Dim>
void holdAtOpening(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Points<Dim>& x,
                   int i, const Driven& driven, Hold<Dim>& hold) {
    for (const int wall : topology.supports[i]) {
        if (wall < 0 || !topology.isOpening(wall)) continue;
        const Vec<Dim> normal = inwardNormal<Dim>(x, topology.walls[wall].nodes);
        if (driven.motion >= 0) hold.along(normal, driven.motion);
        const auto& outlet = conditions.outlet[topology.walls[wall].patch];
        if (!outlet || !outlet->guides() || topology.freeSurface[i]) continue;
        const Tensor<Dim> basis = basisAround<Dim>(normal);
        for (int c = 0; c + 1 < Dim; ++c) hold.along(basis.col(c), -1);
    }
    if (driven.pinned) hold.wholly(driven.motion);
}

/// Along the normal that the face under a rider has after dt.
template <int Dim>
void holdOnSolid(const Topology<Dim>& topology, const Nodes<Dim>& nodes, int ride, double dt, Hold<Dim>& hold) {
    Points<Dim> later;
    Face<Dim> all{};
    for (int k = 0; k < Dim; ++k) {
        const int i = topology.rides[ride].face[k];
        all[k] = k;
        later.push_back(nodes.x[i] + dt * nodes.v[i]);
    }
    hold.along(inwardNormal<Dim>(later, all), -1, ride);
}

}  // namespace

template <int Dim>
NodeConstraints<Dim> nodeConstraints(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                                     const Topology<Dim>& topology, const Nodes<Dim>& nodes, double t0, double t1) {
    const std::size_t n = nodes.x.size();
    NodeConstraints<Dim> c;
    c.freedom.assign(n, {});
    c.followed.assign(n, -1);
    for (const auto& motion : conditions.motion)
        c.motion.push_back(motion ? motion->template step<Dim>(t0, t1) : RigidStep<Dim>());
    giveWay<Dim>(conditions, topology, nodes, t0, t1, c.motion);
    const auto drivenBy = addDriven<Dim>(conditions, topology, nodes, t0, t1, c.motion);
    const auto moverOf = [&](int patch) { return conditions.motion[patch] ? patch : -1; };

    NormalCollector<Dim> planes(n);
    std::vector<int> fixedBy(n, -1), planeOf(n, -1);
    for (std::size_t k = 0; k < mesh.patches.size(); ++k)
        for (const auto& face : mesh.patches[k].faces)
            for (const int node : face) {
                const int patch = static_cast<int>(k);
                if (conditions.type[k]->own == Constraint::fixed || isWall(conditions.kind[k])) fixedBy[node] = patch;
                if (conditions.type[k]->own != Constraint::slide) continue;
                planeOf[node] = patch;
                planes.add(node, faceArea<Dim>(nodes.X, face).normalized());
            }

    for (std::size_t i = 0; i < n; ++i) {
        if (fixedBy[i] < 0 && planeOf[i] < 0 && !topology.onWall[i]) continue;
        Hold<Dim> hold;
        if (fixedBy[i] >= 0) hold.wholly(moverOf(fixedBy[i]));
        if (planeOf[i] >= 0)
            for (const auto& normal : planes.sum[i])
                if (normal.squaredNorm() > 0) hold.along(normal, -1);
        int sticksTo = -1;
        for (int k = 0; topology.onWall[i] && k < Dim && topology.supports[i][k] >= 0; ++k) {
            const int wall = topology.supports[i][k], patch = topology.walls[wall].patch;
            if (topology.isOpening(wall)) continue;
            if (topology.isSkin(wall)) {
                const Ride<Dim>* ride = topology.rideOn(static_cast<int>(i), wall);
                holdOnSolid<Dim>(topology, nodes, static_cast<int>(ride - topology.rides.data()), t1 - t0, hold);
                continue;
            }
            const PatchType& type = *conditions.type[patch];
            const int mover = moverOf(patch);
            Vec<Dim> normal = placeOnRegion<Dim>(topology.walls, nodes.x, wall, nodes.x[i]).normal;
            if (mover >= 0) normal = (c.motion[mover].rotation * normal).eval();
            hold.along(normal, mover);
            if ((topology.freeSurface[i] ? type.contactLine : type.wet) == Constraint::fixed) sticksTo = patch;
        }
        if (sticksTo >= 0) hold.wholly(moverOf(sticksTo));
        if (topology.onOpening(i)) holdAtOpening<Dim>(conditions, topology, nodes.x, i, drivenBy[i], hold);
        c.freedom[i] = hold.freedom();
        if (!hold.moves()) continue;
        c.followed[i] = static_cast<int>(c.following.size());
        c.following.push_back(hold.following());
        const Following<Dim>& f = c.following.back();
        for (int k = 0; k < f.count; ++k)
            if (f.part[k].ride >= 0)
                c.riders.push_back({topology.rides[f.part[k].ride], f.part[k].normal, f.part[k].dual});
    }
    return c;
}

#define PFEM_INSTANTIATE(D)                                                                                          \
    template NodeConstraints<D> nodeConstraints<D>(const Mesh<D>&, const BoundaryConditions<D>&, const Topology<D>&, \
                                                   const Nodes<D>&, double, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
