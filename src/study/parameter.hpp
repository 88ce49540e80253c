#pragma once
// `parameters` of system/sweepDict: the entries that a study changes.

#include <string>
#include <vector>

#include "case/case.hpp"
#include "dictionary/entries.hpp"
#include "study/caseCopy.hpp"

namespace pfem {

struct ParameterEntries {
    std::string file, entry;
    std::vector<double> range;
    std::string scale = "linear";
    int count = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("file", file, "-", "the dictionary, relative to the case: \"constant/materials\"");
        v.required("entry", entry, "-", "the entry; names of dictionaries around it separated by '/': \"rubber/E\"");
        v("range", range, "as the entry", "instead of values: least and largest number");
        v("scale", scale, "-", "how numbers of the range are spaced", oneOf({"linear", "log"}));
        v("count", count, "-", "grid and list: how many numbers of the range, both ends included", atLeast(0));
    }
};

/// The rows of the keyword reference: those above and `values`.
std::vector<EntryDescription> describeParameter();

struct Parameter : ParameterEntries {
    std::string name;
    std::vector<std::string> path;    // of the entry
    std::vector<std::string> values;  // as they are written in a dictionary; empty: a range
    Location where;

    bool isLog() const { return scale == "log"; }
    /// A point of the range, 0 ... 1.
    double at(double part) const;
    /// Where a number is in the range, 0 ... 1.
    double partOf(double number) const;
};

/// One dictionary of `parameters`. Throws UserError.
Parameter readParameter(const Dictionary& dict);

/// The parameter's entry must be written in that file, and the file be one from which the case's dictionaries come:
/// else UserError with the valid words.
void checkParameter(const Case& theCase, const Parameter& parameter);

}  // namespace pfem
