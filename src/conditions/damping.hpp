#pragma once
// Water that is brought to rest, or to a current, in a part of the domain: a sponge at the end of a wave tank.
//
//     sponge { type damping; from (6 0 0); to (8 0 0); rate 5; }          in constant/boundaryConditions

#include <algorithm>
#include <cmath>

#include "base/types.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// The force per volume - rho r(s) (v - velocity), where s goes from 0 at `from` to 1 at `to` and stays 1 beyond:
///     r(s) = rate s^exponent.
template <int Dim>
struct DampingZone {
    Vec<Dim> from = Vec<Dim>::Zero(), to = Vec<Dim>::Zero();  // [m]
    double rate = 0;                                          // [1/s]
    double exponent = 2;
    Vec<Dim> velocity = Vec<Dim>::Zero();  // to which the water is brought, in the world [m/s]

    double at(const Vec<Dim>& x) const {
        const double s = (to - from).dot(x - from) / (to - from).squaredNorm();
        return s <= 0 ? 0 : rate * std::pow(std::min(s, 1.0), exponent);
    }
};

/// Throws UserError.
template <int Dim>
DampingZone<Dim> readDamping(const Dictionary& entry);

}  // namespace pfem
