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
    dict.found("libs");  // accepted and ignored
    dict.subDictOrEmpty("functions");
    return controls;
}

WriteControl writeControlOf(const ControlDict& controls) {
    return WriteControl(controls.writeControl, controls.writeInterval);
}

}  // namespace pfem
