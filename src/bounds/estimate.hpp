#pragma once
// The limit for h -> 0 from two or more mesh sizes, with its uncertainty.
//
// With n(h) = u + a h^q and e(h) = u - b h^q the width of the band is (a + b) h^q, so that two sizes give the
// order
//     q = ln(W1/W2) / ln(h1/h2),    W = integral of the width over time,
// and, at each time, two limits (Richardson):  u_n = n2 - (n1 - n2)/(r^q - 1),  u_e alike,  r = h1/h2.

#include <string>

#include "bounds/band.hpp"

namespace pfem {

struct Estimate {
    std::string obstacle;                    // why there is none, in words; empty: there is one
    double order = 0;                        // q of the two finest meshes
    std::vector<double> value, uncertainty;  // NaN where the band does not hold
};

/// value: the mean of u_n and u_e. uncertainty: the largest distance to u_n and u_e, to both with the formal
/// order 2, and with three sizes or more to the estimate of the next coarser pair of sizes (same order);
/// times Roache's safety factors: 3 for two sizes, which cannot check their own order, 1.25 for more.
Estimate estimate(const Study& study, const Band& band);

}  // namespace pfem
