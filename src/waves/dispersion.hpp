#pragma once
// Small waves on water of constant depth (Airy).

namespace pfem {

/// k of omega^2 = g k tanh(k d), to round-off [1/m].
double waveNumber(double omega, double depth, double gravity);

/// A wave maker at the end of a flume: a piston, or a flap that turns about the bed.
enum class Maker { piston, flap };

/// Amplitude of the waves far away over that of the maker's motion at the still level, q = k d (Havelock, Biesel):
///     piston  2 (cosh 2q - 1)/(sinh 2q + 2q),      flap  4 sinh q (q sinh q - cosh q + 1)/(q (sinh 2q + 2q)).
double makerGain(Maker maker, double q);

/// What stays at a piston, in phase with its displacement: amplitude of the surface beside the waves that go away,
///     sum_j 4 sin^2 q_j/(sin 2q_j + 2q_j),   q_j tan q_j = - q tanh q,   (j - 1/2) pi < q_j < j pi.
double nearFieldGain(double q);

}  // namespace pfem
