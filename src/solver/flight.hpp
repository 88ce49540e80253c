#pragma once
// Drops in free flight: their motion is exact for any step, and nothing limits it but what they are going to
// strike.

#include <vector>

#include "state/state.hpp"

namespace pfem {

/// How soon a drop strikes something [1/s]: the largest of
///   1 / (h/|w_J| + t_J),      w_J = v - v_J,
/// over the nodes J that are no drops, t_J: the time until it comes within h of J, all going on as they do;
/// what it does not come near to does not count. With maxCo times its inverse as step it moves by a part of
/// the way until there, and there by a part of h. A parabola is straight for sqrt(h/|a|); longer steps are
/// not asked for. Walls do not count: it lands where its way crosses them (walls/landing.hpp), and other
/// drops do not. `drops`: looseNodes of the mesh.
template <int Dim>
double strikingRate(const State<Dim>& state, const std::vector<unsigned char>& drops, int drop);

}  // namespace pfem
