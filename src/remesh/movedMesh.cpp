#include "remesh/movedMesh.hpp"

namespace pfem {

template <int Dim>
MovedMesh<Dim> movedMesh(const State<Dim>& state, Topology<Dim> topology, const std::vector<int>& gone) {
    MovedMesh<Dim> moved;
    moved.x = state.nodes.x;
    moved.images = imagesOf<Dim>(state);
    moved.dropVolume = moved.images.counted(state.nodes.dropVolume);
    moved.lostVolume = moved.images.counted(state.nodes.lostVolume);
    moved.gone.assign(moved.x.size(), 0.0);
    for (const int drop : gone) std::swap(moved.gone[drop], moved.dropVolume[drop]);
    moved.fluid = state.mesh.fluid.nodes;
    moved.solid = state.mesh.solid.nodes;
    moved.topology = std::move(topology);
    moved.volume = cellVolume<Dim>(state);
    return moved;
}

#define PFEM_INSTANTIATE(D) template MovedMesh<D> movedMesh<D>(const State<D>&, Topology<D>, const std::vector<int>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
