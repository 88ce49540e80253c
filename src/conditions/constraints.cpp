#include "conditions/constraints.hpp"

#include <cmath>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// Mean normal of the faces that a node belongs to; zero where they differ by more than 20 degrees.
template <int Dim>
struct NormalCollector {
    std::vector<Vec<Dim>> sum;
    std::vector<unsigned char> corner;

    explicit NormalCollector(std::size_t n) : sum(n, Vec<Dim>::Zero()), corner(n, 0) {}

    void add(int node, const Vec<Dim>& n) {
        if (sum[node].squaredNorm() > 0 && sum[node].normalized().dot(n) < std::cos(20 * M_PI / 180)) corner[node] = 1;
        sum[node] += n;
    }
    bool isCorner(int node) const { return corner[node] != 0; }
    Vec<Dim> normal(int node) const {
        return corner[node] || sum[node].squaredNorm() == 0 ? Vec<Dim>(Vec<Dim>::Zero())
                                                            : Vec<Dim>(sum[node].normalized());
    }
};

}  // namespace

template <int Dim>
NodeConstraints<Dim> nodeConstraints(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                                     const Topology<Dim>& topology, const Nodes<Dim>& nodes, double t0, double t1) {
    const std::size_t n = nodes.x.size();
    NodeConstraints<Dim> c;
    c.type.assign(n, Constraint::free);
    c.normal.assign(n, Vec<Dim>::Zero());
    c.mover.assign(n, -1);
    for (const auto& motion : conditions.motion)
        c.motion.push_back(motion ? motion->template step<Dim>(t0, t1) : RigidStep<Dim>());
    const auto moverOf = [&](int patch) { return conditions.motion[patch] ? patch : -1; };

    NormalCollector<Dim> planes(n);
    std::vector<unsigned char> fixed(n, 0), slides(n, 0);
    for (std::size_t k = 0; k < mesh.patches.size(); ++k)
        for (const auto& face : mesh.patches[k].faces)
            for (int node : face) {
                if (conditions.type[k]->own == Constraint::fixed) fixed[node] = 1;
                if (conditions.motion[k]) c.mover[node] = static_cast<int>(k);
                if (conditions.type[k]->own != Constraint::slide) continue;
                slides[node] = 1;
                planes.add(node, faceArea<Dim>(nodes.X, face).normalized());
            }

    for (std::size_t i = 0; i < n; ++i) {
        const int node = static_cast<int>(i);
        if (slides[i]) {
            c.type[i] = planes.isCorner(node) ? Constraint::fixed : Constraint::slide;
            c.normal[i] = planes.normal(node);
        }
        if (topology.onWall[i]) {
            const auto& wall = topology.walls[nodes.wall[i]];
            const PatchType& type = *conditions.type[wall.patch];
            c.type[i] = topology.freeSurface[i] ? type.contactLine : type.wet;
            c.normal[i] = faceArea<Dim>(nodes.x, wall.nodes).normalized();
            if (!topology.corner[i]) c.mover[i] = moverOf(wall.patch);
            if (c.isMoved(node)) c.normal[i] = (c.motion[c.mover[i]].rotation * c.normal[i]).eval();
        }
        if (fixed[i] || topology.corner[i]) c.type[i] = Constraint::fixed;
    }
    return c;
}

#define PFEM_INSTANTIATE(D)                                                                                          \
    template NodeConstraints<D> nodeConstraints<D>(const Mesh<D>&, const BoundaryConditions<D>&, const Topology<D>&, \
                                                   const Nodes<D>&, double, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
