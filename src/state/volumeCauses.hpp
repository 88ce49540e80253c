#pragma once
// Why the fluid's volume changes. A new cause is one line here: its name in files, what becomes of the amount
// (CauseKind), whether it has its nodal field always or once it has been booked, its meaning.

#include "state/causeSums.hpp"

#define PFEM_VOLUME_CAUSES(CAUSE)                                                                               \
    CAUSE(compression, elastic, always, "what pressure takes from the volume or gives back; no change of mass") \
    CAUSE(contact, gainOrLoss, always, "triangles that became fluid where surfaces met")                        \
    CAUSE(correction, gainOrLoss, always, "given back by the continuity equation where nodes lacked it")        \
    CAUSE(gone, passage, onceBooked, "drops that have left for good")                                           \
    CAUSE(inflow, passage, onceBooked, "water that inlets have brought")                                        \
    CAUSE(isolated, gainOrLoss, always, "what particles without triangles carry")                               \
    CAUSE(landed, gainOrLoss, always, "nodes put on walls")                                                     \
    CAUSE(outflow, passage, onceBooked, "water that has left through outlets, negative")                        \
    CAUSE(released, gainOrLoss, always,                                                                         \
          "nodes that walls let go, triangles that carried a node of a wall or solid alone")                    \
    CAUSE(reshaped, gainOrLoss, always, "other triangles between the same nodes, removed nodes of the surface") \
    CAUSE(returned, gainOrLoss, always, "nodes put back out of solids")                                         \
    CAUSE(solver, gainOrLoss, always, "motion by the equations, which are solved to a tolerance")               \
    CAUSE(stretched, gainOrLoss, always, "triangles of the surface too long, flat or about to collapse")        \
    CAUSE(surface, gainOrLoss, always, "shift of the free surface, which makes up for the others")

namespace pfem {

enum class VolumeCause {
#define PFEM_CAUSE(name, kind, field, meaning) name,
    PFEM_VOLUME_CAUSES(PFEM_CAUSE)
#undef PFEM_CAUSE
};

template <>
struct Causes<VolumeCause> {
    static constexpr std::array table{
#define PFEM_CAUSE(name, kind, field, meaning) CauseText{#name, CauseKind::kind, CauseField::field, meaning},
        PFEM_VOLUME_CAUSES(PFEM_CAUSE)
#undef PFEM_CAUSE
    };
};

}  // namespace pfem
