#pragma once
// What limits the time step.

#include "state/state.hpp"

namespace pfem {

/// Rates which times dt are Courant numbers [1/s].
struct CourantRate {
    double largest = 0, mean = 0;  // |v|/h of all nodes but drops in free flight; those that are faster than the rest
                                   // count in the largest by what they are going to strike (solver/flight.hpp)
    double relative = 0;           // largest |v_I - v_J|/h of neighbours in the fluid: how fast triangles change
    double compression =
        0;  // largest -div v of a fluid triangle, and between surfaces that are about to meet or have just met
};
template <int Dim>
CourantRate courantRate(const State<Dim>& state);

/// Largest rate at which simplices between surfaces close, -div v, as if they were no flatter than leastHeight h [1/s].
template <int Dim>
double closingRate(const Nodes<Dim>& nodes, const std::vector<Simplex<Dim>>& simplices, double leastHeight);

}  // namespace pfem
