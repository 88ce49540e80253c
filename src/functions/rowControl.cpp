#include "functions/rowControl.hpp"

#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

bool isWriteTime(const std::string& mode) { return mode == "writeTime" || mode == "outputTime"; }

}  // namespace

const std::vector<std::string>& RowEntries::modes() {
    static const std::vector<std::string> words = [] {
        auto all = WriteControl::modes();
        all.insert(all.end(), {"writeTime", "outputTime"});
        return all;
    }();
    return words;
}

RowControl::RowControl(const Dictionary& function) {
    readEntries(function, entries_);
    const bool old = !function.found("writeControl") && function.found("outputControl");
    const std::string mode = old ? entries_.outputControl : entries_.writeControl;
    const bool oldInterval = !function.found("writeInterval") && function.found("outputInterval");
    const double interval = oldInterval ? entries_.outputInterval : entries_.writeInterval;
    const char* key = oldInterval ? "outputInterval" : "writeInterval";
    if (entries_.timeEnd < entries_.timeStart)
        function.fatal("timeEnd", "'timeEnd' is before 'timeStart': there would be no rows");
    entries_.writeInterval = interval;
    if (isWriteTime(mode)) {
        if (interval != std::floor(interval) || interval > 1e9)
            function.fatal(
                key, std::string("'") + key + "' must be a whole number of time folders with writeControl " + mode);
        return;
    }
    try {
        control_.emplace(mode, interval);
    } catch (const UserError& error) {
        function.fatal(key, error.what());
    }
}

bool RowControl::inWindow(const TimeInfo& time) const {
    const double rounding = 1e-6 * time.deltaT0;
    return time.value >= entries_.timeStart - rounding && time.value <= entries_.timeEnd + rounding;
}

bool RowControl::due(const TimeInfo& time, const FolderDue& folderDue) const {
    if (!inWindow(time)) return false;
    if (control_) return control_->due(time);
    return folderDue && folderDue(static_cast<int>(entries_.writeInterval));
}

}  // namespace pfem
