#include "case/controlDict.hpp"

namespace pfem {

ControlDict readControlDict(const Dictionary& dict) {
    ControlDict controls;
    readEntries(dict, controls);
    controls.startFrom = dict.choice("startFrom", {"firstTime", "startTime", "latestTime"}, controls.startFrom);
    controls.stopAt = dict.choice("stopAt", {"endTime", "writeNow", "noWriteNow", "nextWrite"}, controls.stopAt);
    controls.writeControl = dict.choice("writeControl", WriteControl::modes(), controls.writeControl);
    controls.writeFormat = dict.choice("writeFormat", {"ascii", "binary"}, controls.writeFormat);
    controls.timeFormat = dict.choice("timeFormat", {"general", "fixed", "scientific"}, controls.timeFormat);
    controls.endTime = dict.get<double>("endTime");
    controls.deltaT = dict.get<double>("deltaT");
    if (!(controls.deltaT > 0)) dict.fatal("deltaT", "'deltaT' must be positive");
    if (!(controls.maxCo > 0)) dict.fatal("maxCo", "'maxCo' must be positive");
    if (!(controls.maxDeltaT > 0)) dict.fatal("maxDeltaT", "'maxDeltaT' must be positive");
    if (controls.purgeWrite < 0) dict.fatal("purgeWrite", "'purgeWrite' must not be negative");
    if (controls.timePrecision < 1 || controls.timePrecision > 17)
        dict.fatal("timePrecision", "'timePrecision' must be between 1 and 17");
    if (controls.writePrecision < 1 || controls.writePrecision > 17)
        dict.fatal("writePrecision", "'writePrecision' must be between 1 and 17");
    try {
        writeControlOf(controls);
    } catch (const UserError& error) {
        dict.fatal("writeInterval", error.what());
    }
    dict.found("libs");  // accepted and ignored
    dict.subDictOrEmpty("functions");
    return controls;
}

WriteControl writeControlOf(const ControlDict& controls) {
    return WriteControl(controls.writeControl, controls.writeInterval);
}

}  // namespace pfem
