#pragma once
// `results` of system/sweepDict: one number of a table in postProcessing for each case.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dictionary/entries.hpp"
#include "study/curve.hpp"

namespace pfem {

struct ResultEntries {
    std::string function, file, column;
    std::string value = "max";
    double time = 0;

    /// The numbers that a curve can be turned into.
    static std::vector<std::string> kinds() { return {"max", "min", "last", "mean", "at", "timeOfMax", "timeOfMin"}; }

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("function", function, "-", "the function in controlDict that writes the table");
        v("file", file, "-", "its file, e.g. D of probes; may be left out where there is only one");
        v("column", column, "-",
          "which number: D_x, 1_p (the second probe's p), or the title of a column; may be left out where there is "
          "only "
          "one");
        v("value", value, "-", "what becomes of its course in time; mean: the integral over time divided by it",
          oneOf(kinds()));
        v("time", time, "s", "with `value at`");
    }
};

struct Result : ResultEntries {
    std::string name;
    Location where;
};

/// One dictionary of `results`. Throws UserError.
Result readResult(const Dictionary& dict);

/// The number, NaN where the curve has none (a dry probe). Only times up to `until` [s] count.
double valueOf(const Result& result, const Curve& curve, double until);

/// The same of the case in `root`. Throws UserError with the valid words where function, file or column are not there.
double valueIn(const Result& result, const std::filesystem::path& root, double until);

}  // namespace pfem
