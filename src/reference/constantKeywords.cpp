#include "conditions/contact.hpp"
#include "conditions/periodic.hpp"
#include "material/lawTable.hpp"
#include "material/material.hpp"
#include "reference/keywords.hpp"

namespace pfem {

namespace {

/// One table for each law, from the declarations by which it is read.
std::vector<KeywordTable> lawKeywords(const std::string& file) {
    std::string words;
    std::vector<KeywordTable> tables;
    const auto add = [&](const auto& laws, const std::vector<EntryDescription>& common) {
        for (const auto& law : laws) {
            words += " " + law.name;
            std::vector<EntryDescription> rows = common;
            rows.insert(rows.end(), law.entries.begin(), law.entries.end());
            tables.push_back({file, law.name, law.meaning, rows});
        }
    };
    add(fluidLaws(), describeEntries<ViscousFluid>());
    add(solidLaws(), describeEntries<Solid>());
    tables.insert(tables.begin(), {file,
                                   "",
                                   "One dictionary per material under its name. Dimensions [..] may stand before a "
                                   "value and are checked.",
                                   {{"type", "word", "-", "required", "the law", "one of:" + words}}});
    return tables;
}

}  // namespace

// What setup.cpp reads beside the laws; a test compares the names.
std::vector<KeywordTable> constantKeywords() {
    std::vector<KeywordTable> tables = lawKeywords("constant/materials");
    tables.push_back({"constant/g",
                      "",
                      "Gravity.",
                      {{"dimensions", "dimensions", "-", "optional", "checked: [0 1 -2 0 0 0 0]", ""},
                       {"value", "vector of time", "m/s2", "required", "acceleration of gravity", ""},
                       {"frameVelocity", "vector of time", "m/s", "at rest",
                        "of a box that moves, in which the case is told: all places and velocities are seen from it, "
                        "still water comes with the opposite velocity",
                        ""}}});
    tables.push_back(
        {"constant/contact", "",
         "Contact of solids with walls and with each other. Without this file they pass through each other, "
         "and a run stops where a solid leaves through a wall.",
         describeEntries<ContactConditions>()});
    auto periodic = describeEntries<PeriodicEntries>();
    periodic.push_back({"flowRate", "vector of time", "m2/s (2D), m3/s", "none",
                        "volume through the sides, the mean over all sections between them, held by a body force on "
                        "the fluid along them",
                        ""});
    periodic.push_back({"meanVelocity", "vector of time", "m/s", "none",
                        "of the whole fluid, held likewise, instead of flowRate", ""});
    tables.push_back(
        {"constant/periodic", "",
         "Periodic sides: what leaves through one of two opposite planes comes in at the other. Walls along "
         "the flow go on beyond both by 5 mesh sizes; gravity may drive the flow, or a flow is held.",
         periodic});
    return tables;
}

}  // namespace pfem
