#pragma once
// Periodic waves that go on as they are, over water of constant depth: Stokes' of fifth order and cnoidal ones.

#include <vector>

namespace pfem {

/// eta = sum_j amplitude_j cos j theta, theta = k (x - c t); no water is carried on the whole (closed flumes).
struct PermanentWave {
    double k = 0, c = 0;            // [1/m], [m/s]
    std::vector<double> amplitude;  // of cos theta, cos 2 theta, ... [m]

    double surface(double theta) const;
    /// Integral of the surface over theta from 0, periodic.
    double integral(double theta) const;
};

/// Height and period of waves on water of this depth.
struct RegularWave {
    double height, period, depth, gravity = 9.81;  // [m], [s], [m], [m/s2]
};

/// Stokes' waves of fifth order (Fenton 1985): for waves shorter than some ten depths.
PermanentWave stokesWave(const RegularWave& wave);

/// Cnoidal waves of first order (Korteweg and de Vries): for longer ones, H L^2/d^3 > 26 or so. With the parameter m of
/// the elliptic functions and their nome q,
///     eta = H (2 pi^2/(m K^2)) sum_n n q^n/(1 - q^2n) cos n theta,   H L^2/d^3 = 16/3 m K^2,
///     c^2 = g d (1 + H/(m d) (2 - m - 3 E/K)).
PermanentWave cnoidalWave(const RegularWave& wave);

/// Is the wave too short or too long for the theory? What separates both is Ursell's number H L^2/d^3.
double ursell(const PermanentWave& wave, const RegularWave& of);

/// The piston that goes with the water of a permanent wave (Goring), X' = c eta/(d + eta) at the plate. With the phase
/// theta = k (c t - X) there,
///     k c t = theta + I(theta)/d,   X = I(theta)/(k d),   I: integral of the surface.
class PermanentMotion {
public:
    PermanentMotion(PermanentWave wave, double depth) : wave_(std::move(wave)), depth_(depth) {}
    double value(double t) const;
    /// eta at the plate [m].
    double surface(double t) const { return wave_.surface(phaseAt(t)); }

private:
    double phaseAt(double t) const;

    PermanentWave wave_;
    double depth_;
};

}  // namespace pfem
