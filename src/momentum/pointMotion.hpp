#pragma once
// How solids move in a trial, as their laws take it.

#include "conditions/problem.hpp"
#include "integration/stressPoints.hpp"

namespace pfem {

/// The domains at the positions whose gradients the cells' laws take (Kinematics): (x^n + x)/2, x or X. Cells of laws
/// of different kinds have different ones.
template <int Dim>
void updateGradientDomains(const Problem<Dim>& problem, const Cells<Dim>& cells, const Nodes<Dim>& old,
                           const Nodes<Dim>& trial, SmoothingDomains<Dim>& domains);

/// A trial motion at the stress points.
template <int Dim>
struct PointMotion {
    const Problem<Dim>& problem;
    const Cells<Dim>& cells;
    const SmoothingDomains<Dim>& domains;
    PerPoint<Tensor<Dim>> gradient;  // as the laws take it
    double dt;
};

template <int Dim>
PointMotion<Dim> pointMotion(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                             const Nodes<Dim>& old, const Nodes<Dim>& trial, double dt);

}  // namespace pfem
