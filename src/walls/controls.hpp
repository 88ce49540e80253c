#pragma once
// How fluid comes to walls and solids and leaves them: entries of `remeshing` in system/pfemSolution.

#include "dictionary/entries.hpp"

namespace pfem {

struct WallControls {
    double wallTension = 1;

    template <class Visitor>
    void entries(Visitor& v) {
        v("wallTension", wallTension, "-",
          "suction / (rho (g h + v^2/2) + mu v/h) at which the contact line lets go of a rigid wall", nonNegative);
    }
};

/// Of `expert` there: what hardly changes results (doc/decisions.md).
struct WallDistances {
    double wallDistance = 0.05;
    double landingDistance = 0.1;
    double cornerDistance = 0.2;

    template <class Visitor>
    void entries(Visitor& v) {
        v("wallDistance", wallDistance, "-", "distance / h to which a node that entered a solid is returned", positive);
        v("landingDistance", landingDistance, "-",
          "distance / h at which a fluid node that approaches a rigid wall lands on it and slides along", nonNegative);
        v("cornerDistance", cornerDistance, "-",
          "distance / h at which a node that slides into a corner of the walls is removed", nonNegative);
    }
};

}  // namespace pfem
