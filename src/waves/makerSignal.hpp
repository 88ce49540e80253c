#pragma once
// How a wave maker has to move for waves that one wants: displacement at the still level over time [m].

#include "waves/dispersion.hpp"
#include "waves/spectrum.hpp"

namespace pfem {

struct Flume {
    double depth = 0, gravity = 9.81;  // [m], [m/s2]
    Maker maker = Maker::piston;
};

/// The motion for a surface (at the maker) that is a sum of small waves: each over its gain, a quarter of a period
/// later.
std::vector<Sine> motionFor(const std::vector<Sine>& surface, const Flume& flume);

/// Regular waves of height H and period T, H/(2 m) sin wt with the gain m. `secondOrder` (pistons): with the part of
/// 2 omega that keeps free second harmonics away (secondOrderPiston.hpp).
std::vector<Sine> regularMotion(double height, double period, bool secondOrder, const Flume& flume);

/// The surface at a piston that moves so, in small waves: what goes away and what stays there (nearFieldGain).
std::vector<Sine> surfaceAtPiston(const std::vector<Sine>& motion, const Flume& flume);

/// The same of regularMotion; `secondOrder`: with what is bound to the waves at 2 omega (Stokes),
///     (k H^2/16) cosh q (2 + cosh 2q)/sinh^3 q,   q = k d.
std::vector<Sine> regularSurface(double height, double period, bool secondOrder, const Flume& flume);

/// Solitary wave of height a (Goring's piston with Rayleigh's profile): the plate goes with the water,
///     X' = c eta/(d + eta),   eta = a sech^2(K (c (t - t0) - X)),   c^2 = g (d + a),   K^2 = 3 a/(4 d^2 (d + a)),
/// that is X = a/(K d) tanh(K (c (t - t0) - X)). It begins at rest at t = 0 and 0.1 % of its stroke.
class SolitaryMotion {
public:
    SolitaryMotion(double height, const Flume& flume);
    double value(double t) const;
    /// eta at the plate [m].
    double surface(double t) const;

private:
    double phaseAt(double t) const;

    double a_, d_, c_, K_;
};

/// What comes in per time and width in waves with this surface [m2/s]: each times its omega/k.
std::vector<Sine> inflowFor(const std::vector<Sine>& surface, const Flume& flume);

/// Sum of the sines.
double sumAt(const std::vector<Sine>& sines, double t);
double rateAt(const std::vector<Sine>& sines, double t);

}  // namespace pfem
