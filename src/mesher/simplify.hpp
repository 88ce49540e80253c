#pragma once
// Outlines of CAD and drawing programs have often more points than the mesh size can show.

#include "mesher/sizeField.hpp"

namespace pfem {

/// The arrangement without the vertices that `thinOut` leaves out. Vertices stay where outlines part or meet, at the
/// ends of walls and patches, and on arcs and structured patterns.
struct Simplified {
    Arrangement arrangement;
    std::vector<int> leftOut;  // per outline: how many vertices, with tips of spikes
    bool changed() const;
};

Simplified simplify(const Arrangement& arrangement, const MeshDescription& mesh, const SizeField& size);

}  // namespace pfem
