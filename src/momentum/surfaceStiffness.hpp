#pragma once
// How heavy fluid resists that its surface, or the solid on it, rises: the stiffness of gravity waves, for the
// matrices.

#include "conditions/problem.hpp"
#include "integration/midpointRule.hpp"

namespace pfem {

/// Lumped diagonal, per direction, of the derivative of the hydrostatic force on the fluid's faces by the velocity at
/// the end of the step,
///     gamma dt/2 sum_faces rho max(0, -g . n) |face|/d,  along g,
/// over gamma [kg/s per m (2D)]. Faces: free surface and solids, n out of the fluid; and that of
/// outlets (addOutletStiffness). It shapes the iteration's path,
/// not its end: without it steps above some 1.5 sqrt(h/g) do not converge.
template <int Dim>
Points<Dim> surfaceStiffness(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                             const Points<Dim>& x, const MidpointRule& midpoint);

/// massFactor m + stiffness: the diagonal of a node's momentum matrix without internal forces. A stiffness below a
/// twentieth of the rest is left out, so that what falls freely falls exactly.
template <int Dim>
Vec<Dim> matrixInertia(double mass, const Vec<Dim>& stiffness, const MidpointRule& midpoint) {
    const double own = midpoint.massFactor() * mass;
    return Vec<Dim>::Constant(own) + (stiffness.array() < 0.05 * own).select(Vec<Dim>::Zero(), stiffness);
}

/// The same of all nodes.
template <int Dim>
Points<Dim> matrixInertia(const std::vector<double>& mass, const Points<Dim>& stiffness, const MidpointRule& midpoint);

}  // namespace pfem
