#include "momentum/bentWalls.hpp"

#include <algorithm>

#include "base/chosen.hpp"
#include "mesh/simplex.hpp"
#include "mesh/skinPoints.hpp"

namespace pfem {

namespace {

/// Is the face a chord of a bent rigid wall, or of two round a convex edge? Solids bear what is on their nodes.
template <int Dim>
bool isChord(const Topology<Dim>& topology, const FluidFace<Dim>& face) {
    if (face.wall < 0 || topology.isSkin(face.wall)) return false;
    if (std::any_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return topology.onSolid[node]; }))
        return false;
    return std::any_of(face.nodes.begin(), face.nodes.end(), [&](int node) {
        const int own = topology.supportOn(node, face.wall);
        return topology.walls[own].bent || topology.walls[own].region != topology.walls[face.wall].region;
    });
}

template <int Dim>
bool isOnSkin(const Topology<Dim>& topology, const FluidFace<Dim>& face) {
    return face.wall >= 0 && topology.isSkin(face.wall);
}

/// visit(face, its points on a solid) for chords, of which there are none, and faces on skins with points there.
template <int Dim, class Visit>
void forChords(const Topology<Dim>& topology, const Points<Dim>& x, const Visit& visit) {
    const auto found = parallelChosen(static_cast<int>(topology.faces.size()), [&](int f) {
        return isOnSkin<Dim>(topology, topology.faces[f]) || isChord<Dim>(topology, topology.faces[f]);
    });
    for (const int f : found) {
        const auto& face = topology.faces[f];
        const bool onSkin = isOnSkin<Dim>(topology, face);
        const auto points = onSkin ? skinPoints<Dim>(topology, x, face) : std::vector<SkinPoint<Dim>>();
        if (!onSkin || !points.empty()) visit(face, points);
    }
}

/// The mean of the face's values by these weights.
template <int Dim>
double meanOf(const std::vector<double>& value, const Face<Dim>& face, const Vec<Dim>& weights) {
    double sum = 0;
    for (int k = 0; k < Dim; ++k) sum += weights[k] * value[face[k]];
    return sum;
}

/// int_f N_I N_J dS = |f| (1 + delta_IJ)/(Dim (Dim + 1)).
template <int Dim>
double weight(int I, int J) {
    return (I == J ? 2.0 : 1.0) / (Dim * (Dim + 1));
}

}  // namespace

template <int Dim>
void addChordPressure(const Topology<Dim>& topology, const Nodes<Dim>& nodes, Points<Dim>& force) {
    forChords<Dim>(topology, nodes.x, [&](const FluidFace<Dim>& face, const std::vector<SkinPoint<Dim>>& points) {
        const Vec<Dim> area = faceArea<Dim>(nodes.x, face.nodes);
        for (const auto& point : points)
            point.onSolid.spread(point.part * meanOf<Dim>(nodes.p, face.nodes, point.onFluid) * area, force);
        for (int J = 0; J < Dim; ++J)
            for (int I = 0; I < Dim; ++I) force[face.nodes[J]] -= weight<Dim>(I, J) * nodes.p[face.nodes[I]] * area;
    });
}

template <int Dim>
void subtractChordFlux(const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, const Nodes<Dim>& nodes,
                       std::vector<double>& residual) {
    forChords<Dim>(topology, nodes.x, [&](const FluidFace<Dim>& face, const std::vector<SkinPoint<Dim>>& points) {
        const Vec<Dim> area = faceArea<Dim>(nodes.x, face.nodes);
        for (const auto& point : points)
            for (int I = 0; I < Dim; ++I)
                residual[face.nodes[I]] += point.part * point.onFluid[I] * area.dot(point.onSolid.under(nodes.v));
        for (int J = 0; J < Dim; ++J) {
            const Vec<Dim>& v = nodes.v[face.nodes[J]];
            const double flux = area.dot(points.empty() ? constraints.project(face.nodes[J], v) : v);
            for (int I = 0; I < Dim; ++I) residual[face.nodes[I]] -= weight<Dim>(I, J) * flux;
        }
    });
}

#define PFEM_INSTANTIATE(D)                                                                            \
    template void addChordPressure<D>(const Topology<D>&, const Nodes<D>&, Points<D>&);                \
    template void subtractChordFlux<D>(const Topology<D>&, const NodeConstraints<D>&, const Nodes<D>&, \
                                       std::vector<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
