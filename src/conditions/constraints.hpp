#pragma once
// How patches hold nodes in a step.

#include "conditions/boundaryConditions.hpp"
#include "state/state.hpp"

namespace pfem {

template <int Dim>
struct NodeConstraints {
    std::vector<Constraint> type;
    std::vector<Vec<Dim>> normal;        // of sliding nodes, at the end of the step
    std::vector<int> mover;              // per node: the motion that it follows, -1: held at rest
    std::vector<RigidStep<Dim>> motion;  // over the step

    /// The part of u that node i may perform.
    Vec<Dim> project(int i, const Vec<Dim>& u) const {
        if (type[i] == Constraint::free) return u;
        if (type[i] == Constraint::slide) return u - normal[i] * normal[i].dot(u);
        return Vec<Dim>::Zero();
    }
    bool isMoved(int i) const { return mover[i] >= 0; }

    /// u with the held part taken from `prescribed`.
    Vec<Dim> combine(int i, const Vec<Dim>& u, const Vec<Dim>& prescribed) const {
        return project(i, u) + (prescribed - project(i, prescribed));
    }
    /// Position of node i after the step: free part of x, held part carried from xOld.
    Vec<Dim> position(int i, const Vec<Dim>& xOld, const Vec<Dim>& x) const {
        return isMoved(i) ? combine(i, x, motion[mover[i]].carried(xOld)) : x;
    }
    /// Velocity of node i at x after the step: free part of v, held part of the motion.
    Vec<Dim> velocity(int i, const Vec<Dim>& x, const Vec<Dim>& v) const {
        return isMoved(i) ? combine(i, v, motion[mover[i]].velocityAt(x)) : project(i, v);
    }
};

/// Constraints of all nodes for the step from t0 to t1. On symmetry patches normals come from the reference positions
/// X; a node where two of them meet at more than 20 degrees is fixed. A fluid node on a slip wall slides along its wall
/// face; on a no-slip wall it sticks, except at the contact line, which could not move otherwise. Solids hold before
/// walls. What is held follows the motion of its patch.
template <int Dim>
NodeConstraints<Dim> nodeConstraints(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                                     const Topology<Dim>& topology, const Nodes<Dim>& nodes, double t0, double t1);

}  // namespace pfem
