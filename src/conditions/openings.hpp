#pragma once
// What an inlet brings and what an outlet asks for: entries of constant/boundaryConditions.
//
//     left   { type inlet;  flowRate { type table; values ((0 0) (1 0.02)); }  profile parabolic; }
//     right  { type outlet; level 0.3; }

#include <limits>
#include <memory>
#include <optional>

#include "dictionary/expression.hpp"
#include "dictionary/function1.hpp"

namespace pfem {

/// Water that comes through a patch: its rate over time, from `start` to `stop`, and how it is spread over the patch.
struct Inlet {
    enum class Profile { uniform, parabolic, expression };

    Function1Ptr<double> rate;  // volume per time [m2/s (2D), m3/s], or mean speed normal to the patch [m/s]
    bool ofVolume = false;      // which of them
    Profile profile = Profile::uniform;
    std::optional<Expression> shape;                      // of x, y, z, t: speed up to a factor
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // of the water; zero: normal to the patch
    double start = -std::numeric_limits<double>::max();   // [s]
    double stop = std::numeric_limits<double>::max();     // [s]

    double at(double t) const { return t >= start && t < stop ? rate->value(t) : 0; }
    /// Integral of the rate over [from, to].
    double during(double from, double to) const {
        const double a = std::max(from, start), b = std::min(to, stop);
        return b > a ? rate->integral(a, b) : 0;
    }
};

/// Where water leaves: under no load, under a pressure, or under that of still water up to a level, and of the waves
/// that have gone out there.
struct Outlet {
    Function1Ptr<double> pressure;  // [Pa]; null: none
    Function1Ptr<double> level;     // of the water outside, against gravity [m]; null: none
    double waveSpeed = 0;           // of waves that go out over this level [m/s]; 0: they are thrown back

    /// Water outside guides it: it goes straight through.
    bool guides() const { return (pressure || level) && waveSpeed == 0; }
};

}  // namespace pfem
