#pragma once
// How fast waves cross a triangle: the limits of the step where nothing moves yet.

#include "conditions/problem.hpp"

namespace pfem {

/// sqrt(g/h) of the finest fluid: waves as short as a triangle have some 1.8 times this angular frequency [1/s]. 0
/// without fluid or gravity.
template <int Dim>
double gravityWaveRate(const Problem<Dim>& problem, const State<Dim>& state);

/// Largest c/h of the solids, c = sqrt((lambda + 2 mu)/rho) [1/s].
template <int Dim>
double elasticWaveRate(const Problem<Dim>& problem, const State<Dim>& state);

}  // namespace pfem
