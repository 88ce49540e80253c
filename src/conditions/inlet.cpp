// Where water comes in, with a prescribed velocity.

#include "conditions/patchType.hpp"

namespace pfem {

namespace {

std::shared_ptr<const Inlet> readInlet(const Dictionary& entry, bool plane) {
    auto inlet = std::make_shared<Inlet>();
    if (entry.found("velocity") && entry.found("flowRate"))
        entry.fatal("flowRate", "Give either velocity or flowRate, not both");
    inlet->ofVolume = entry.found("flowRate");
    if (!inlet->ofVolume && !entry.found("velocity"))
        throw UserError("An inlet needs one of: velocity flowRate", entry.where());
    inlet->rate = readFunction1<double>(entry, inlet->ofVolume ? "flowRate" : "velocity");
    const auto profile = entry.choice("profile", {"uniform", "parabolic", "expression"}, "uniform");
    if (profile == "parabolic") {
        inlet->profile = Inlet::Profile::parabolic;
        if (!plane)
            entry.fatal("profile", "A parabola is for plane cases; in space write its formula: profile expression;");
    }
    if (profile == "expression") {
        inlet->profile = Inlet::Profile::expression;
        inlet->shape.emplace(entry.get<std::string>("shape"), std::vector<std::string>{"x", "y", "z", "t"},
                             entry.where("shape"));
    }
    inlet->direction = entry.get("direction", inlet->direction);
    if (plane) demandPlane(entry, "direction", inlet->direction[2]);
    inlet->start = entry.get("start", inlet->start);
    inlet->stop = entry.get("stop", inlet->stop);
    if (!(inlet->stop > inlet->start)) entry.fatal("stop", "An inlet must stop after it has started");
    return inlet;
}

}  // namespace

PatchType inletPatch() {
    return {.name = "inlet",
            .meaning = "water comes in",
            .kind = PatchKind::opening,
            .wet = Constraint::fixed,
            .contactLine = Constraint::slide,
            .entries = {{"velocity", "scalar of time", "m/s", "required, or flowRate",
                         "of an inlet: mean speed into the fluid, normal to the wet part of the patch", ""},
                        {"flowRate", "scalar of time", "m2/s (2D), m3/s", "required, or velocity",
                         "of an inlet: volume that comes in per time", ""},
                        {"profile", "word", "-", "uniform",
                         "how the speed is spread over the patch; parabolic (2D): zero at its two ends",
                         "one of: uniform parabolic expression"},
                        {"shape", "string", "-", "required for profile expression",
                         "formula of x, y, z, t: the speed up to a factor, which the rate gives", ""},
                        {"direction", "vector", "-", "normal to the patch", "of the water that comes in", ""},
                        {"start", "scalar", "s", "none", "no water comes in before", ""},
                        {"stop", "scalar", "s", "none", "nor from this time on", "> start"}},
            .read = [](const Dictionary& entry, bool plane) {
                PatchEntries e;
                e.inlet = readInlet(entry, plane);
                return e;
            }};
}

}  // namespace pfem
