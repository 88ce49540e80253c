#pragma once
// All that a run knows at one instant; a time folder holds exactly this, but for the ledger's fields. Only nodes carry
// history, and with elemental integration the solid's cells (Cells::sigma, Cells::history), which last for the whole
// run.

#include <map>
#include <string>
#include <vector>

#include "case/timeInfo.hpp"
#include "mesh/mesh.hpp"
#include "state/energyCauses.hpp"
#include "state/nodes.hpp"
#include "state/placeSizes.hpp"
#include "state/volumeLedger.hpp"

namespace pfem {

template <int Dim>
struct State {
    TimeInfo time;
    Nodes<Dim> nodes;
    Mesh<Dim> mesh;
    PlaceSizes<Dim> sizes;  // that hold for the whole run
    Id nextId = 0;          // the id of the next node to be inserted
    double approach = 0;    // how fast surfaces that are about to meet, or have just met, close: largest -div v of the
                            // triangles between [1/s]
    VolumeLedger ledger;  // cumulative fluid volume by cause; its fields, if any, are those since the last time folder:
                          // a run that goes on begins with zeros, for it begins with a time folder
    EnergyLedger energy;  // what came beside the equations of motion, by cause
    std::map<std::string, std::vector<double>> memory;  // of function objects, by their name
};

}  // namespace pfem
