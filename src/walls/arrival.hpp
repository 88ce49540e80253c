#pragma once
// Where nodes come to walls on their ways.

#include <functional>
#include <limits>

#include "mesh/topology.hpp"
#include "mesh/wallBins.hpp"
#include "state/nodes.hpp"

namespace pfem {

/// A wall to which a node comes, and after which part of its way.
struct Arrival {
    double part = std::numeric_limits<double>::max();  // it does not
    int wall = -1;

    bool any() const { return wall >= 0; }
};

template <int Dim>
class Arrivals {
public:
    /// On ways from xOld to nodes.x; what a node comes nearer to than `distance` h counts. All must outlive it.
    Arrivals(double distance, const Topology<Dim>& topology, const Points<Dim>& xOld, const Nodes<Dim>& nodes);

    /// What node i comes to first, of the wanted walls that do not hold it: it has crossed the face or is near it. What
    /// is part of the fluid arrives at the end of its way; a drop, whose way may be many h long, where it has crossed.
    Arrival first(int i, const std::function<bool(int wall)>& wanted) const;

private:
    Arrival at(int i, int wall) const;

    double distance_;
    const Topology<Dim>& topology_;
    const Points<Dim>& xOld_;
    const Nodes<Dim>& nodes_;
    WallBins<Dim> bins_;
    Points<Dim> normal_, normalOld_;  // of the walls, into the fluid
    double travel_ = 0;               // the longest way of a wall's point [m]
};

/// Is a node on a wall that is joined with this one?
template <int Dim>
bool isHeldBy(const Topology<Dim>& topology, const Supports<Dim>& supports, int wall);

}  // namespace pfem
