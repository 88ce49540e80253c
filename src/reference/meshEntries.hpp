#pragma once
// Rows that system/meshDict has in two and in three dimensions.

#include <string>

#include "reference/keywords.hpp"

namespace pfem::meshEntries {

/// `ofCells`: "triangles'".
inline EntryDescription size(const std::string& ofCells) {
    return {"meshSize", "scalar", "m", "that of the dictionary above", "wanted length of the " + ofCells + " edges",
            "> 0"};
}

inline EntryDescription arcs(const std::string& of) {
    return {"edges",
            "list of arc",
            "m",
            "()",
            of + "curved edges: arc 0 1 (x y), a circular arc from vertex 0 to 1 through a point",
            ""};
}

/// The first rows of a body.
inline std::vector<EntryDescription> bodyRows() {
    return {{"type", "word", "-", "required", "fluid or solid", "one of: fluid solid"},
            {"material", "word", "-", "required", "a name of constant/materials", ""}};
}

inline EntryDescription velocity(const std::string& zero, const std::string& example) {
    return {"velocity", "point", "m/s", zero, "initial velocity; of the place: expression (" + example + ")", ""};
}

/// `instead`: the entry whose place it takes; `cells`: of the group.
inline EntryDescription group(const std::string& owner, const std::string& instead, const std::string& cells) {
    return {"group",
            "word",
            "-",
            "the " + owner + "'s name",
            "with meshFile, instead of " + instead + ": its group of " + cells,
            ""};
}

inline EntryDescription patches(const std::string& whole) {
    return {"patches",
            "dictionaries",
            "-",
            "optional",
            "parts of the " + whole + " that constant/boundaryConditions speaks of",
            ""};
}

inline EntryDescription moving(const std::string& shared) {
    return {"moving",
            "bool",
            "-",
            "no",
            "it shares no " + shared + " with other walls, so that it can leave or slide over them",
            ""};
}

inline EntryDescription distance(const std::string& of) {
    return {"distance", "scalar", "m", "0", "of a " + of + ": how far from it the size holds", ">= 0"};
}

/// Tables of rows and lists of rows.
inline std::vector<EntryDescription> joined(std::vector<EntryDescription> rows,
                                            const std::vector<EntryDescription>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

}  // namespace pfem::meshEntries
