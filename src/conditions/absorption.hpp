#pragma once
// A wall that gives way to waves: a piston that moves away from those that come, beside its own motion if it has one.
//
//     motion { absorb { depth 0.4; period 1.6; } }                                // throws nothing back
//     motion { displacement { type waveMaker; ... }  absorb { } }                 // and makes waves

#include <algorithm>
#include <functional>

#include "base/types.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// Waves of the amplitude a come to a wall, which answers with the velocity U. With the gains c of the waves that it
/// makes and n of what stays before it (waves/dispersion.hpp), in complex amplitudes
///     eta = 2 a + (c - i n) U/omega,        nothing goes back:  a + c U/omega = 0,
/// so that U + (n/c) U'/omega = - (omega/c) eta: a plate with a lag. This holds at one omega.
struct Absorption {
    double depth = 0;                                 // of the still water [m]
    double rate = 0;                                  // omega/c [1/s]
    double lag = 0;                                   // n/(c omega), and that of the return [s]
    double returning = 0;                             // part of its way that the wall comes back per time [1/s]
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();    // of the depth, unit vector
    std::function<double(double)> wanted = nullptr;   // surface of its own waves over time [m]; null: none
    Eigen::Vector3d scale = Eigen::Vector3d::Zero();  // of its own motion; into the water as a wave maker means it

    /// Velocity after dt of a wall that answers with U now and has come the way so far. The lag is a step at least;
    /// what it is too long the excess of the surface is taken later, a time `ahead` after now:
    ///     lag (U' - U)/dt + (U + U')/2 = - rate excess - returning (way + dt/2 U).
    double answer(double U, double way, double excess, double dt) const;
    double ahead(double dt) const { return 0.5 * dt + std::max(lag, dt) - lag; }

    /// Height of its own waves at time t before a wall whose water is in the direction `into` [m].
    double own(double t, const Eigen::Vector3d& into) const { return wanted ? scale.dot(into) * wanted(t) : 0; }
};

/// The entry `absorb` of a motion: depth, period (of the wave maker, if there is one), gravity, up. UserError: it
/// turns, or its displacement is not that of a wave maker.
Absorption readAbsorption(const Dictionary& motion, bool plane);

}  // namespace pfem
