#pragma once
// An inlet that no water wets yet: a nozzle in the air, before the jet begins.

#include "walls/openings.hpp"

namespace pfem {

/// At inlets without wet nodes, for the step from t0 to t1: what comes in is carried by a row of nodes on the patch, as
/// drops carry it; when it is as thick as half of h, a second row is laid before them and the water between becomes
/// triangles, of the same volume. h: the patch's. In space nothing is done: there an inlet starts wet.
template <int Dim>
void fillDryInlets(const PassageStep<Dim>& step, State<Dim>& state);

/// The first inlet that is to bring water in this step, but has no wet node; -1: none.
template <int Dim>
int dryInlet(const PassageStep<Dim>& step, const State<Dim>& state);

}  // namespace pfem
