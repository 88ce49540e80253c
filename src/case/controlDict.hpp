#pragma once
// system/controlDict: OpenFOAM's keywords and meaning.

#include <limits>
#include <string>

#include "case/writeControl.hpp"
#include "dictionary/dictionary.hpp"
#include "dictionary/entries.hpp"

namespace pfem {

struct ControlDict {
    std::string application;
    std::string startFrom = "latestTime";
    double startTime = 0;
    std::string stopAt = "endTime";
    double endTime = 0;
    double deltaT = 0;
    std::string writeControl = "timeStep";
    double writeInterval = 1;
    int purgeWrite = 0;
    std::string writeFormat = "binary";
    int writePrecision = 6;
    std::string writeCompression = "on";
    std::string timeFormat = "general";
    int timePrecision = 6;
    bool runTimeModifiable = true;
    bool adjustTimeStep = false;
    double maxCo = 0.4;
    double maxRelativeCo = 0.2;
    double maxCompression = 0.7;
    double maxWaveCo = 0.5;
    double maxSolidCo = 1e300;
    double maxGrowth = 1.2;
    double maxDeltaT = 1e300;

    template <class Visitor>
    void entries(Visitor& v) {
        v("application", application, "-", "the solver's name, for Allrun scripts");
        v("startFrom", startFrom, "-", "the time folder to begin with",
          oneOf({"firstTime", "startTime", "latestTime"}));
        v("startTime", startTime, "s", "where a run begins with startFrom startTime");
        v("stopAt", stopAt, "-", "when to stop; may be changed while the run goes on",
          oneOf({"endTime", "writeNow", "noWriteNow", "nextWrite"}));
        v.required("endTime", endTime, "s", "end of the run; the last step is shortened where it would pass it");
        v.required("deltaT", deltaT, "s",
                   "time step, also after a restart with another value; with adjustTimeStep the first one of the case",
                   positive);
        v("writeControl", writeControl, "-",
          "what writeInterval means; adjustable: steps end exactly on the write times", oneOf(WriteControl::modes()));
        v("writeInterval", writeInterval, "steps or s", "distance of the written times", positive);
        v("purgeWrite", purgeWrite, "-", "number of time folders of this run to keep; 0 keeps all", atLeast(0));
        v("writeFormat", writeFormat, "-", "accepted; the state is always binary", oneOf({"ascii", "binary"}));
        v("writePrecision", writePrecision, "digits", "digits of tables in postProcessing", between(1, 17));
        v("writeCompression", writeCompression, "-", "accepted; the state is always compressed");
        v("timeFormat", timeFormat, "-", "how time folders are named", oneOf({"general", "fixed", "scientific"}));
        v("timePrecision", timePrecision, "digits", "digits of time names; raised when two would be equal",
          between(1, 17));
        v("runTimeModifiable", runTimeModifiable, "-", "read this file again when it changes during the run");
        v("adjustTimeStep", adjustTimeStep, "-",
          "choose the time step by maxCo, maxRelativeCo, maxCompression, maxWaveCo and maxSolidCo");
        v("maxCo", maxCo, "-", "largest |v| deltaT/h of a node", positive);
        v("maxRelativeCo", maxRelativeCo, "-", "largest |v_I - v_J| deltaT/h of two neighbours in the fluid", positive);
        v("maxCompression", maxCompression, "-",
          "largest -div v deltaT of a triangle, the part of its area that it would lose by its velocities: of the "
          "fluid, and of "
          "the air between surfaces that are about to meet",
          positive);
        v("maxWaveCo", maxWaveCo, "-",
          "largest deltaT sqrt(g/h): gravity waves as short as a triangle are resolved by 2 pi/(1.8 maxWaveCo) steps a "
          "period; "
          "the only limit of water at rest",
          positive);
        v("maxSolidCo", maxSolidCo, "-",
          "largest c deltaT/h of elastic waves in solids, c = sqrt((lambda + 2 mu)/rho); about 1 to follow impacts on "
          "them",
          positive);
        v("maxGrowth", maxGrowth, "-", "adjustTimeStep: largest ratio of a step to the one before", atLeast(1.0));
        v("maxDeltaT", maxDeltaT, "s", "adjustTimeStep: largest time step", positive);
    }
};

/// Check everything and mark all known keywords of `dict` as used. Throws UserError.
ControlDict readControlDict(const Dictionary& dict);

/// When the state is to be written.
WriteControl writeControlOf(const ControlDict& controls);

}  // namespace pfem
