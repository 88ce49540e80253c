#pragma once
// Why energy comes and goes with the fluid's volume and connectivity, beside the equations of motion. A new cause is
// one line here.

#include "state/causeSums.hpp"

#define PFEM_ENERGY_CAUSES(CAUSE)                                       \
    CAUSE(remeshing, "landing on walls, contacts and new connectivity") \
    CAUSE(volume, "volume that the equations lost, and what they gave back against pressure")

namespace pfem {

enum class EnergyCause {
#define PFEM_CAUSE(name, meaning) name,
    PFEM_ENERGY_CAUSES(PFEM_CAUSE)
#undef PFEM_CAUSE
};

template <>
struct Causes<EnergyCause> {
    static constexpr std::array table{
#define PFEM_CAUSE(name, meaning) CauseText{#name, CauseKind::passage, CauseField::always, meaning},
        PFEM_ENERGY_CAUSES(PFEM_CAUSE)
#undef PFEM_CAUSE
    };
};

/// Cumulative [J/m (2D), J].
using EnergyLedger = CauseSums<EnergyCause>;

}  // namespace pfem
