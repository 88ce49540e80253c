#include "momentum/bentWalls.hpp"

#include <algorithm>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// Is the face a chord of a bent wall, or of two round a convex edge? Solids bear what is on their nodes.
template <int Dim>
bool isChord(const Topology<Dim>& topology, const FluidFace<Dim>& face) {
    if (face.wall < 0) return false;
    if (std::any_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return topology.onSolid[node]; }))
        return false;
    return std::any_of(face.nodes.begin(), face.nodes.end(), [&](int node) {
        const int own = topology.supportOn(node, face.wall);
        return topology.walls[own].bent || topology.walls[own].region != topology.walls[face.wall].region;
    });
}

/// int_f N_I N_J dS = |f| (1 + delta_IJ)/(Dim (Dim + 1)).
template <int Dim>
double weight(int I, int J) {
    return (I == J ? 2.0 : 1.0) / (Dim * (Dim + 1));
}

}  // namespace

template <int Dim>
void addChordPressure(const Topology<Dim>& topology, const Nodes<Dim>& nodes, Points<Dim>& force) {
    for (const auto& face : topology.faces) {
        if (!isChord<Dim>(topology, face)) continue;
        const Vec<Dim> area = faceArea<Dim>(nodes.x, face.nodes);
        for (int J = 0; J < Dim; ++J)
            for (int I = 0; I < Dim; ++I) force[face.nodes[J]] -= weight<Dim>(I, J) * nodes.p[face.nodes[I]] * area;
    }
}

template <int Dim>
void subtractChordFlux(const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, const Nodes<Dim>& nodes,
                       std::vector<double>& residual) {
    for (const auto& face : topology.faces) {
        if (!isChord<Dim>(topology, face)) continue;
        const Vec<Dim> area = faceArea<Dim>(nodes.x, face.nodes);
        for (int J = 0; J < Dim; ++J) {
            const double flux = area.dot(constraints.project(face.nodes[J], nodes.v[face.nodes[J]]));
            for (int I = 0; I < Dim; ++I) residual[face.nodes[I]] -= weight<Dim>(I, J) * flux;
        }
    }
}

#define PFEM_INSTANTIATE(D)                                                                            \
    template void addChordPressure<D>(const Topology<D>&, const Nodes<D>&, Points<D>&);                \
    template void subtractChordFlux<D>(const Topology<D>&, const NodeConstraints<D>&, const Nodes<D>&, \
                                       std::vector<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
