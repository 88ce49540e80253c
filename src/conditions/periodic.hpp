#pragma once
// Periodic sides: constant/periodic. What leaves through one of two opposite sides comes in at the other.
//
//     x   (0 2);

#include <cmath>
#include <string>

#include "dictionary/entries.hpp"
#include "state/images.hpp"

namespace pfem {

struct PeriodicEntries {
    std::vector<double> x, y, z;

    template <class Visitor>
    void entries(Visitor& v) {
        v("x", x, "m", "the case repeats itself between two planes of constant x: (from to)");
        v("y", y, "m", "the same for y");
        v("z", z, "m", "the same for z");
    }
};

/// The box of these entries. Its sides are rounded so that shifts by a period are exact (state/unfolding.hpp). Throws
/// UserError where an entry is no interval, or of a direction that there is not.
template <int Dim>
Period<Dim> periodOf(const Dictionary& dict, const PeriodicEntries& entries) {
    const std::vector<double>* sides[] = {&entries.x, &entries.y, &entries.z};
    const char* names[] = {"x", "y", "z"};
    Period<Dim> period;
    for (int k = 0; k < 3; ++k) {
        const auto& side = *sides[k];
        if (side.empty()) continue;
        if (k >= Dim) dict.fatal(names[k], "the case is plane: it has no sides in z");
        if (side.size() != 2 || !(side[1] > side[0]))
            dict.fatal(names[k], "two planes, the lower one first, for example (0 2)");
        const double grain = grainOf(side[0], side[1] - side[0]);
        period.from[k] = std::round(side[0] / grain) * grain;
        period.length[k] = std::round(side[1] / grain) * grain - period.from[k];
    }
    return period;
}

}  // namespace pfem
