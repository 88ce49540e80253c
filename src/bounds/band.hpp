#pragma once
// The band between a nodal and an elemental computation of one quantity, and where it means something.
//
// Proved (linear elasticity, the solid's own energy under given loads): compatible elements are too stiff;
// found by experiment: nodal stress is too soft. So the nodal curve goes FARTHER from the state of rest than
// the elemental one, and both come nearer to each other as the mesh gets finer. Where the curves do not
// behave so they bracket nothing.

#include <string>
#include <vector>

#include "study/curve.hpp"

namespace pfem {

/// One mesh size, both integrations, at the times of the study.
struct Twin {
    double h = 0;  // mesh size [m]
    std::vector<double> nodal, elemental;
};

/// One quantity on all mesh sizes, coarse to fine.
struct Study {
    std::vector<double> t;  // [s]
    std::vector<Twin> twins;
};

/// Differences below this part of the range of the curves count as none.
constexpr double narrow = 1e-3;

/// What the two curves are to each other at one time.
enum class Bracket {
    missing = -9,   // a curve has no value
    leaves = -2,    // the band is not inside the one of the next coarser mesh: too coarse
    reversed = -1,  // the nodal curve is nearer to the state of rest, or on the other side of it
    none = 0,       // nearer to each other than 1/1000 of the range: neither
    holds = 1
};

struct Band {
    std::vector<double> lower, upper;  // of the finest mesh
    std::vector<Bracket> bracket;
    double range = 0;  // largest less smallest value of both curves

    std::vector<bool> where(Bracket value) const;
};

/// Throws UserError when the study has no times.
Band makeBand(const Study& study);

/// Times at which the finest nodal and elemental curves cross, those within 1/1000 of the range left out.
std::vector<double> crossings(const Study& study, const Band& band);

/// Mean and largest width, and when it is largest.
struct Width {
    double mean = 0, largest = 0, when = 0;
};
Width widthOf(const Study& study, const Band& band);

/// How a curve lies to the band: part of the time for which both have values, part of that inside, largest
/// distance outside and when.
struct Containment {
    double compared = 0, inside = 0, farthest = 0, when = 0;
    std::vector<Span> outside;
};

/// `reference` at the times t; `slack`: what counts as inside although it is outside (0: nothing).
Containment containment(const std::vector<double>& t, const Band& band, const std::vector<double>& reference,
                        double slack = 0);

}  // namespace pfem
