#pragma once
// Where water hardly moves.

namespace pfem {

/// Square of the speed below which a node is slow beside the waves of a triangle's length, g h/10 [m2/s2].
inline double calmSpeedSquared(double gravity, double h) { return 0.1 * gravity * h; }

}  // namespace pfem
