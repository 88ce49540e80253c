#include <algorithm>
#include <iterator>

#include "conditions/patchType.hpp"
#include "reference/keywords.hpp"

namespace pfem {

// The types of patches with their entries; what wallMotion.cpp and boundaryConditions.cpp read beside, a test compares
// the names.
std::vector<KeywordTable> conditionKeywords() {
    const std::string conditions = "constant/boundaryConditions";
    std::string meanings;
    for (const auto& type : patchTypes()) meanings += (meanings.empty() ? "" : "; ") + type.name + ": " + type.meaning;
    std::vector<EntryDescription> rows{{"type", "word", "-", "required", meanings, oneOf(typeNames()).text}};
    const auto isNew = [&](const EntryDescription& entry) {
        return std::none_of(rows.begin(), rows.end(), [&](const auto& row) { return row.name == entry.name; });
    };
    for (const auto& type : patchTypes())
        std::copy_if(type.entries.begin(), type.entries.end(), std::back_inserter(rows), isNew);
    rows.push_back({"motion", "dictionary", "-", "at rest", "how a wall or a clamped patch moves", ""});
    return {
        {conditions, "", "One dictionary per wall and per named patch of system/meshDict.", rows},
        {conditions,
         "sideWalls",
         "Walls in front of and behind a plane flow, with friction (2D). Under any name that no patch has.",
         {{"width", "scalar", "m", "required", "their distance", "> 0"},
          {"friction", "scalar", "-", "required",
           "c_f of each, as of slip walls: force per volume - rho c_f |v| v / width", ">= 0"}}},
        {conditions,
         "damping",
         "Water that is brought to rest, or to a current: a sponge for waves. Force per volume - rho r (v - velocity), "
         "r = rate s^exponent, s from 0 at `from` to 1 at `to` and beyond. Under any name that no patch has.",
         {{"from", "vector", "m", "required", "where it begins", ""},
          {"to", "vector", "m", "required", "where it has its full rate", "not from"},
          {"rate", "scalar", "1/s", "required", "the largest r; good for waves: their omega = 2 pi/T", ">= 0"},
          {"exponent", "scalar", "-", "2", "of its growth on the way", ">= 0"},
          {"velocity", "vector", "m/s", "(0 0 0)",
           "to which the water is brought, in the world if the case is told in a box that moves", ""}}},
        {conditions,
         "motion",
         "A rigid motion: a displacement, or a turn about a point that is displaced, or both. Values of time are "
         "written as "
         "OpenFOAM's: constant, table, tableFile, polynomial, sine, square, scale; also expression and waveMaker.",
         {{"displacement", "vector of time", "m", "none", "from the place at time 0", ""},
          {"velocity", "vector of time", "m/s", "none", "instead of displacement", ""},
          {"angle", "scalar of time", "rad", "none", "of the turn since time 0, counter-clockwise", ""},
          {"omega", "scalar of time", "rad/s", "none", "instead of angle", ""},
          {"origin", "vector", "m", "required for a turn", "the point that is turned about, at time 0", ""},
          {"axis", "vector", "-", "(0 0 1)", "of the turn", ""},
          {"absorb", "dictionary", "-", "none",
           "a piston that gives way to waves that come to it; a displacement beside is one with type waveMaker", ""}}},
        {conditions,
         "motion: absorb",
         "How a wall gives way to waves: as a piston that makes none but its own, by the height of the water before "
         "it. "
         "For waves of the period; of others more comes back.",
         {{"depth", "scalar", "m", "that of the wave maker", "of the still water at the wall", "> 0"},
          {"period", "scalar", "s", "that of the wave maker", "of the waves that come; of a sea that of its peak",
           "> 0"},
          {"gravity", "scalar", "m/s2", "that of the wave maker, 9.81", "for the wave numbers", "> 0"},
          {"up", "vector", "-", "(0 1 0), in space (0 0 1)", "of the depth", "not zero"}}},
        {conditions,
         "motion: type waveMaker",
         "How a wave maker moves for the waves that one wants: as displacement of a piston, or as angle of a flap that "
         "turns about the bed.",
         {{"theory", "word", "-", "airy",
           "regular waves (airy; secondOrder: without free second harmonics; stokes5 for steep, cnoidal for long "
           "ones), one "
           "solitary wave, a sea, a focused group",
           "one of: airy secondOrder stokes5 cnoidal solitary jonswap piersonMoskowitz focused"},
          {"maker", "word", "-", "piston",
           "what moves; inlet: the value is what comes in per width, for the flowRate of an inlet [m2/s]",
           "one of: piston flap inlet"},
          {"depth", "scalar", "m", "required", "of the still water", "> 0"},
          {"height", "scalar", "m", "required",
           "of the waves; of a sea the significant one, of a focused group its crest", "> 0"},
          {"period", "scalar", "s", "required but for solitary", "of a sea that of the spectrum's peak", "> 0"},
          {"ramp", "scalar", "s", "period", "time in which the motion grows to its full size", ""},
          {"start", "scalar", "s", "0", "at rest before", ""},
          {"gamma", "scalar", "-", "3.3", "peak enhancement of JONSWAP", ""},
          {"components", "int", "-", "200", "sines of a sea", ">= 1"},
          {"seed", "int", "-", "1", "of the phases: another number, another sea of the same spectrum", ""},
          {"focusTime", "scalar", "s", "required for focused", "when the crests meet", ""},
          {"focusPlace", "scalar", "m", "0", "and how far from the wave maker", ""},
          {"gravity", "scalar", "m/s2", "9.81", "for the wave numbers", "> 0"},
          {"scale", "vector or scalar", "-", "(1 0 0), of an angle 1", "direction of the motion", ""}}},
    };
}

}  // namespace pfem
