#include <fmt/format.h>

#include "functions/forces.hpp"
#include "functions/front.hpp"
#include "functions/line.hpp"
#include "functions/massLedger.hpp"
#include "functions/momentumBalance.hpp"
#include "functions/pressureSensor.hpp"
#include "functions/rowControl.hpp"
#include "functions/surfaces.hpp"
#include "functions/volumeFlow.hpp"
#include "functions/waveGauge.hpp"
#include "functions/waveReflection.hpp"
#include "reference/keywords.hpp"

namespace pfem {

namespace {

/// A line per cause of a ledger.
template <class Cause>
std::string causeList() {
    std::string text = "\n";
    for (const auto& cause : Causes<Cause>::table) text += fmt::format("\n* `{}`: {}", cause.name, cause.meaning);
    return text;
}

}  // namespace

std::vector<KeywordTable> functionKeywords() {
    const std::string file = "system/controlDict, functions";
    const EntryDescription fields{"fields", "list of word", "-", "required", "fields by name", "U a D p sigma h"};
    std::vector<EntryDescription> all{
        {"type", "word", "-", "required", "what the function does; one of another program is left out with a warning",
         oneOf(functionTypes()).text},
        {"enabled", "bool", "-", "yes", "leave the function out", ""}};
    for (auto& row : describeEntries<RowEntries>()) all.push_back(row);
    all.push_back({"writePrecision", "int", "digits", "that of controlDict", "digits of the numbers", ""});
    all.push_back({"libs", "list of word", "-", "optional", "accepted and ignored", ""});
    return {
        {file, "",
         "One dictionary per function under a name of its own, in braces or, as a list, in brackets; its tables are in "
         "`postProcessing/<name>/<startTime>`.",
         all},
        {file, "boundingBox", "Lower and upper corners of fluid and solids; no entries.", {}},
        {file,
         "energy",
         "Stored energies, dissipation, works, and what the numerics dissipate; no entries. What came beside the "
         "equations of motion, by cause:" +
             causeList<EnergyCause>(),
         {}},
        {file, "fieldMinMax", "Extremes of fields and where they are.", {fields}},
        {file, "forces", "Force and moment of the fluid on walls and solids; reactions of supports.",
         describeEntries<ForcesEntries>()},
        {file, "front", "How far the main body of fluid has come.", describeEntries<FrontEntries>()},
        {file, "line", "Fields along a straight line, a file per time.", describeEntries<LineEntries>()},
        {file, "massLedger",
         "Fluid volume and mass, and what changed them: a column per cause, the volume that appeared by it." +
             causeList<VolumeCause>(),
         describeEntries<MassLedgerEntries>()},
        {file, "momentumBalance",
         "Momentum of the fluid between two planes, and what changes it: flow and pressure through both, walls, "
         "gravity, "
         "viscosity, and what the numerics lose.",
         describeEntries<MomentumBalanceEntries>()},
        {file,
         "periodicFlow",
         "The flow through periodic sides, and the force that holds it where `flowRate` or `meanVelocity` is given in "
         "`constant/periodic`: `drive`, an acceleration; the pressure drop between the sides is rho `drive` L. No "
         "entries.",
         {}},
        {file, "pressureSensor", "Mean pressure over a disc or segment on a wall or solid.",
         describeEntries<PressureSensorEntries>()},
        {file,
         "probes",
         "Fields at points.",
         {fields,
          {"probeLocations", "list of vector", "m", "required", "the points; also called points", ""},
          {"points", "list of vector", "m", "optional", "another word for probeLocations", ""},
          {"fixedLocations", "bool", "-", "yes",
           "no: the points ride on the material that holds them at the first time", ""},
          {"interpolationScheme", "word", "-", "optional", "accepted; values are linear in the triangle", ""},
          {"includeOutOfBounds", "bool", "-", "optional", "accepted; a point without material gives -1e+300", ""}}},
        {file,
         "rigidBodyState",
         "Places, turning and velocities of rigid bodies, with the columns of OpenFOAM's sixDoFRigidBodyState; no "
         "entries.",
         {}},
        {file, "surfaces", "Cuts, the free surface and the solids' skin with fields, as .vtp files for ParaView.",
         describeEntries<SurfacesEntries>()},
        {file, "volumeFlow", "Volume of fluid that passes a plane: its rate, and the sum since the beginning.",
         describeEntries<VolumeFlowEntries>()},
        {file, "waveGauge", "Elevation of the free surface.", describeEntries<WaveGaugeEntries>()},
        {file, "waveReflection", "Waves that go past a row of gauges and those that come back, by least squares.",
         describeEntries<WaveReflectionEntries>()},
    };
}

}  // namespace pfem
