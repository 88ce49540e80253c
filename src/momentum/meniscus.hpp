#pragma once
// The meniscus: where the surface meets a place that it sticks to, a node of a solid or a corner of walls.
//
// Such a place is seldom on the water's level, and a surface that slopes down to it (or up) would never come to rest:
// water would slide along the slope for ever. So the last face carries the hydrostatic pressure of its slope, as the
// meniscus of a real contact line does by its tension: what stands above the level hangs on the solid, what is missing
// below it is borne by the solid. Its height is that of the mesh, and its force, rho g h^2/6 at most, vanishes with h.

#include <array>

#include "conditions/problem.hpp"

namespace pfem {

/// Pressure at the nodes of a face of the free surface [Pa]: weight . (x_I - x_0) at a place that the surface sticks
/// to, x_0 the mean of the face's free nodes, and within weight h of it; 0 at free nodes, and where no node is free.
/// Times 1 - v^2/(g h/10), no less than 0, of the face's fastest node: impacts and jets know no meniscus.
template <int Dim>
std::array<double, Dim> meniscusPressure(const Problem<Dim>& problem, double rho, const Topology<Dim>& topology,
                                         const Nodes<Dim>& nodes, const Face<Dim>& face);

/// Add to the force what this pressure makes of each free node, - A p_I/(d (d+1)) with the face's area A, and the
/// opposite to the place that it hangs on: momentum stays.
template <int Dim>
void addMeniscus(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                 const Nodes<Dim>& nodes, Points<Dim>& force);

/// Work of these forces in a step, as its momentum has them at x_m = (1 - gamma) x^n + gamma x and v_m [J/m (2D), J].
template <int Dim>
double meniscusWork(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                    const Nodes<Dim>& old, const Nodes<Dim>& now, double gamma);

}  // namespace pfem
