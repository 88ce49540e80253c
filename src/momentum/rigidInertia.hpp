#pragma once
// The momentum equation of rigid bodies: force and moment that their mass and what restrains them ask for.

#include "momentum/solidMatrix.hpp"
#include "momentum/trial.hpp"

namespace pfem {

/// Levers of the body's nodes in the middle of the step, where the forces act.
template <int Dim>
Points<Dim> middleLevers(const Step<Dim>& step, const RigidBody<Dim>& body, const Trial<Dim>& trial, int index);

/// Add to R, spread over the bodies' nodes,
///     F = M (v_c - v_c^n)/dt - M g - restraints,    moment = (L - L^n)/dt + rho x (F's part) - restraints,
/// v_c: velocity of the centre of mass, L: angular momentum about it, rho: from the reference point to it.
template <int Dim>
void addRigidInertia(const Step<Dim>& step, const Trial<Dim>& trial, Points<Dim>& R);

/// Add the bodies' blocks to the solids' matrix: massFactor times the generalised mass, and what restraints add.
template <int Dim>
void addRigidMatrix(const Step<Dim>& step, SolidBlock<Dim>& block);

/// The directions of the bodies' unknowns with the levers in the middle of the step.
template <int Dim>
void setLevers(const Step<Dim>& step, const Trial<Dim>& trial, SolidDofs<Dim>& dofs);

}  // namespace pfem
