#pragma once
// How patches hold nodes in a step.

#include "conditions/boundaryConditions.hpp"
#include "conditions/freedom.hpp"
#include "conditions/riders.hpp"
#include "conditions/rigidBody.hpp"
#include "state/state.hpp"

namespace pfem {

/// What a node does in its held directions: n_k . u = n_k . u_k with what the motion k gives, u_k.
template <int Dim>
struct Following {
    struct Part {
        Vec<Dim> normal, dual;  // dual_k . n_l = 1 for k = l, else 0
        int motion;             // -1: at rest
        int ride = -1;          // of Topology::rides: along with the solid (riders.hpp), beside what the motion gives
    };
    std::array<Part, Dim> part;
    int count = 0;
};

template <int Dim>
struct NodeConstraints {
    std::vector<Freedom<Dim>> freedom;
    std::vector<int> followed;  // per node: its Following, -1: what is held is at rest
    std::vector<Following<Dim>> following;
    std::vector<RigidStep<Dim>> motion;  // over the step, of the patches, then of nodes that inlets drive
    std::vector<RigidBody<Dim>> bodies;  // whose nodes move together (rigidBodies.hpp)
    std::vector<Rider<Dim>> riders;      // of the fluid on solids; they take what is held from them, too

    /// The part of u that node i may perform.
    Vec<Dim> project(int i, const Vec<Dim>& u) const { return freedom[i].project(u); }
    bool isMoved(int i) const { return followed[i] >= 0; }

    /// u with the held part taken from `prescribed`.
    Vec<Dim> combine(int i, const Vec<Dim>& u, const Vec<Dim>& prescribed) const {
        return project(i, u) + (prescribed - project(i, prescribed));
    }
    /// Position of node i after the step: free part of x, held part carried from xOld.
    Vec<Dim> position(int i, const Vec<Dim>& xOld, const Vec<Dim>& x) const {
        if (!isMoved(i)) return x;
        return withHeld(i, x, [&](int m) { return m < 0 ? xOld : motion[m].carried(xOld); });
    }
    /// Velocity of node i at x after the step: free part of v, held part of the motions.
    Vec<Dim> velocity(int i, const Vec<Dim>& x, const Vec<Dim>& v) const {
        if (!isMoved(i)) return project(i, v);
        return withHeld(i, v, [&](int m) { return m < 0 ? Vec<Dim>(Vec<Dim>::Zero()) : motion[m].velocityAt(x); });
    }

private:
    template <class Value>
    Vec<Dim> withHeld(int i, const Vec<Dim>& u, const Value& valueOf) const {
        Vec<Dim> result = project(i, u);
        const Following<Dim>& f = following[followed[i]];
        for (int k = 0; k < f.count; ++k) result += f.part[k].dual * f.part[k].normal.dot(valueOf(f.part[k].motion));
        return result;
    }
};

/// Constraints of all nodes for the step from t0 to t1. On symmetry patches normals come from the reference positions
/// X; those that differ by less than 20 degrees are one. A fluid node on a slip wall slides over it, along the edge of
/// two; on a no-slip wall it sticks, except at the contact line, which could not move otherwise. Clamps hold before
/// walls. What is held follows the motion of its patch; at openings see holdAtOpening (constraints.cpp). On a solid it
/// is the normal that its face has at t1, by its nodes' velocities of t0.
template <int Dim>
NodeConstraints<Dim> nodeConstraints(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                                     const Topology<Dim>& topology, const Nodes<Dim>& nodes, double t0, double t1);

}  // namespace pfem
