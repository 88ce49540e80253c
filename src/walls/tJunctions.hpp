#pragma once
// T-junctions: walls that stand on other walls: the foot of a piston or of a gate on the floor.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// A corner of one wall that lies on a face of another wall, none of whose ends it is, stands on it: Nodes::wall is
/// that face, and the fluid's nodes on the face cannot pass. Corners that have left their face get -1.
/// `isWall`: per patch of the mesh.
void standOnWalls(const Mesh<2>& mesh, const std::vector<bool>& isWall, Nodes<2>& nodes);

/// Where a wet foot is about to leave the face on which it stands, a new node of the fluid takes its place in the
/// fluid's cells and slides on that face: the corner goes with its wall, the water stays. `v`: velocities to come.
/// True if there was such a foot.
bool leaveTJunctions(const Topology<2>& topology, const Points<2>& v, State<2>& state);

/// Free ends of walls that move along their own face, as the lower edge of a gate does that is being lifted. They
/// would drag the fluid along; as long as they move so, they are no nodes of its mesh.
std::vector<int> looseEnds(const Mesh<2>& mesh, const std::vector<bool>& isWall, const Nodes<2>& nodes);

/// TJunctions of other walls, which nothing that slides on the same face can pass.
class TJunctions {
public:
    TJunctions(const Topology<2>& topology, const Nodes<2>& nodes);

    /// Where on face w a node stops that was at xOld and has come to s.
    double stop(const Topology<2>& topology, int w, const Points<2>& xOld, const Nodes<2>& nodes, int i,
                double s) const;

private:
    std::vector<int> junctions_;
};

}  // namespace pfem
