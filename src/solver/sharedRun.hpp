#pragma once
// A run that ranks share: each has the whole state and the same bits. Of what is large each works off a part and gets
// the others': the first triangulation, lists of neighbours, residuals, the pressure's rows.

#include "solver/simulation.hpp"

namespace pfem {

/// From now on `ranks` share the simulation's work, or the threads of a single one its triangulation. Throws UserError
/// in the plane, where ranks have nothing to share.
template <int Dim>
void shareAmong(const Ranks& ranks, Simulation<Dim>& simulation);

/// What the other ranks do in a run: the start, if there is one, and steps, of which the first one says by its ofFirst
/// that there is another, and how long it is, until it says that there is none.
template <int Dim>
void followFirst(const Ranks& ranks, Simulation<Dim>& simulation);

/// After a step: the first one's time is that of all. Throws UserError when the states differ in a bit.
template <int Dim>
void agree(const Ranks& ranks, State<Dim>& state);

}  // namespace pfem
