#pragma once
// Part of Newton's step that is taken where it overshoots.

#include "base/types.hpp"

namespace pfem {

/// A fluid with yield stress is stiff below and soft above it: Newton's steps then swing to and fro across the bend for
/// ever. With d the new step and d' the last one, of which the part w' was taken, w = w' / (1 - d.d'/d'.d') is the
/// secant's: half of a step that would just undo the last one, all of it where steps have one direction. At most 1, at
/// least 0.1. The converged step is not changed.
template <int Dim>
class NewtonDamping {
public:
    /// The part of this step to take.
    double next(const Points<Dim>& step);

private:
    Points<Dim> last_;
    double part_ = 1;
};

}  // namespace pfem
