#pragma once
// Isotropic elasticity of small strain.

#include "dictionary/range.hpp"

namespace pfem {

inline const Range poissonsRatio{
    .text = "> -1 and < 0.5", .lower = -1, .upper = 0.5, .lowerIncluded = false, .upperIncluded = false, .words = {}};

/// Young's modulus and Poisson's ratio, and the other constants that follow from them.
struct IsotropicElasticity {
    double E = 1e6;  // Young's modulus [Pa]
    double nu = 0;   // Poisson's ratio [-]

    double lambda() const { return E * nu / ((1 + nu) * (1 - 2 * nu)); }
    double mu() const { return E / (2 * (1 + nu)); }
    double kappa() const { return E / (3 * (1 - 2 * nu)); }

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("E", E, "Pa", "Young's modulus", positive);
        v.required("nu", nu, "-", "Poisson's ratio", poissonsRatio);
    }
};

/// The constants with shear modulus mu and bulk modulus kappa [Pa].
inline IsotropicElasticity elasticityOf(double mu, double kappa) {
    return {9 * kappa * mu / (3 * kappa + mu), (3 * kappa - 2 * mu) / (2 * (3 * kappa + mu))};
}

}  // namespace pfem
