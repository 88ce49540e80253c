#pragma once
// When a function object writes a row of its tables.

#include <functional>
#include <optional>

#include "case/writeControl.hpp"
#include "dictionary/entries.hpp"

namespace pfem {

/// Entries that all functions have, in OpenFOAM's words.
struct RowEntries {
    std::string writeControl = "timeStep";
    double writeInterval = 1;
    double timeStart = -1e300;
    double timeEnd = 1e300;
    std::string executeControl = "timeStep";
    double executeInterval = 1;
    std::string outputControl = "timeStep";
    double outputInterval = 1;

    template <class Visitor>
    void entries(Visitor& v) {
        v("writeControl", writeControl, "-",
          "what writeInterval means; adjustable: as runTime, steps are fitted to the time folders alone; writeTime: "
          "with the time "
          "folders and at the end of the run (outputTime is the old word)",
          oneOf(modes()));
        v("writeInterval", writeInterval, "steps, s or folders", "distance of the rows", positive);
        v("timeStart", timeStart, "s",
          "no rows before; what is summed or filtered over time begins with the run all the same");
        v("timeEnd", timeEnd, "s", "no rows after it");
        v("executeControl", executeControl, "-",
          "accepted: sums and filters take in every step, rows come by writeControl", oneOf(modes()));
        v("executeInterval", executeInterval, "steps, s or folders", "accepted, as executeControl", positive);
        v("outputControl", outputControl, "-", "the old word for writeControl", oneOf(modes()));
        v("outputInterval", outputInterval, "steps, s or folders", "the old word for writeInterval", positive);
    }

    /// The valid words for `writeControl` of a function.
    static const std::vector<std::string>& modes();
};

/// Is a time folder due now, counting every n-th only? True at the end of the run.
using FolderDue = std::function<bool(int n)>;

/// Depends on the state's time and nothing else, so that a restarted run writes the same rows.
class RowControl {
public:
    /// Throws UserError.
    explicit RowControl(const Dictionary& function);

    /// Is `time` between timeStart and timeEnd?
    bool inWindow(const TimeInfo& time) const;

    /// Is a row to be written at the end of the step that led to `time`?
    bool due(const TimeInfo& time, const FolderDue& folderDue) const;

private:
    RowEntries entries_;
    std::optional<WriteControl> control_;  // none: with the time folders
};

}  // namespace pfem
