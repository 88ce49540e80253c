#pragma once
// The fluid mesh of the step before, moved with its nodes: it says what is fluid.

#include "mesh/topology.hpp"
#include "state/volume.hpp"

namespace pfem {

/// A copy of what remeshing needs of the old mesh; node indices are those before remeshing.
template <int Dim>
struct MovedMesh {
    Points<Dim> x;
    std::vector<double> dropVolume;  // as Nodes::dropVolume
    std::vector<double> lostVolume;  // as Nodes::lostVolume
    std::vector<double> gone;        // what drops carry that are let go now; not in dropVolume
    std::vector<int> joins;  // the node that a drop is going to be part of, -1: none (joinDrops.hpp); empty: nobody
    std::vector<Simplex<Dim>> fluid;
    std::vector<Simplex<Dim>> solid;
    Topology<Dim> topology;
    Images<Dim> images;  // beyond periodic sides: they carry nothing, and no decision is made for them
    double volume = 0;   // of all fluid cells that count
};

/// `topology`: of the state's mesh; `gone`: drops that are let go.
template <int Dim>
MovedMesh<Dim> movedMesh(const State<Dim>& state, Topology<Dim> topology, const std::vector<int>& gone = {});

}  // namespace pfem
