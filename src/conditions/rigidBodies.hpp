#pragma once
// The rigid bodies of a case.

#include "conditions/problem.hpp"

namespace pfem {

/// Are there any among the materials?
template <int Dim>
bool hasRigidBodies(const Problem<Dim>& problem);

/// The bodies without what patches hold.
template <int Dim>
std::vector<RigidBody<Dim>> rigidBodies(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const Nodes<Dim>& nodes);

/// Bodies of rigid cells that share nodes, with mass and inertia from mesh and material, pose and twist from `nodes`.
/// What `constraints` says of their nodes becomes constraints of the bodies (a clamp: the whole motion), and their
/// nodes are free there. UserError: a body follows two motions, or is held in a moving frame.
template <int Dim>
void addRigidBodies(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const Nodes<Dim>& nodes,
                    NodeConstraints<Dim>& constraints);

}  // namespace pfem
