#pragma once
// Contact of solids with walls and with each other: constant/contact.

#include "dictionary/entries.hpp"

namespace pfem {

struct ContactConditions {
    bool on = false;      // there is a file constant/contact
    double friction = 0;  // Coulomb's coefficient

    template <class Visitor>
    void entries(Visitor& v) {
        v("friction", friction, "-", "Coulomb's coefficient between solids, and between solids and walls", nonNegative);
    }
};

}  // namespace pfem
