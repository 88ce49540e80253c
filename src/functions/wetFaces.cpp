#include "functions/wetFaces.hpp"

#include <map>

#include "mesh/sortedFace.hpp"

namespace pfem {

template <int Dim>
std::vector<WetFace<Dim>> wetFaces(const State<Dim>& state, const Topology<Dim>& topology) {
    std::map<Face<Dim>, int> materialOfSolid;
    for (const auto& face : topology.solidFaces)
        materialOfSolid[sorted<Dim>(face.nodes)] = state.mesh.solid.material[face.cell];
    std::vector<WetFace<Dim>> result;
    for (const auto& face : topology.faces) {
        WetFace<Dim> wet{face.nodes, face.cell, -1, -1};
        wet.under.fill(Vec<Dim>::Zero());
        if (face.kind == FaceKind::interface)
            wet.solid = materialOfSolid.at(sorted<Dim>(face.nodes));
        else if (face.kind == FaceKind::wall) {
            if (face.wall < 0) continue;
            wet.patch = topology.walls[face.wall].patch;
            if (topology.isSkin(face.wall)) {
                wet.solid = materialOfSolid.at(sorted<Dim>(topology.walls[face.wall].nodes));
                for (std::size_t k = 0; k < Dim; ++k)
                    if (const auto* ride = topology.rideOn(face.nodes[k], face.wall))
                        wet.under[k] = ride->under(state.nodes.v);
            }
        } else
            continue;
        result.push_back(wet);
    }
    return result;
}

#define PFEM_INSTANTIATE(D) template std::vector<WetFace<D>> wetFaces<D>(const State<D>&, const Topology<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
