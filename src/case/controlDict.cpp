#include "case/controlDict.hpp"

namespace pfem {

ControlDict readControlDict(const Dictionary& dict) {
    ControlDict controls;
    readEntries(dict, controls);
    try {
        writeControlOf(controls);
    } catch (const UserError& error) {
        dict.fatal("writeInterval", error.what());
    }
    if (controls.endTime / controls.deltaT > 1e12)
        dict.fatal("deltaT", "'deltaT' is so small that endTime would take more than 1e12 steps");
    dict.found("libs");  // accepted and ignored
    dict.found("functions");
    return controls;
}

WriteControl writeControlOf(const ControlDict& controls) {
    return WriteControl(controls.writeControl, controls.writeInterval);
}

}  // namespace pfem
