// The written times of a case, one a line; or removes them.

#include <filesystem>
#include <iostream>
#include <optional>

#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "base/error.hpp"
#include "case/runLock.hpp"
#include "case/timeFolders.hpp"
#include "io/series.hpp"

using namespace pfem;

int main(int argc, char** argv) {
    OptionsSpec spec;
    spec.addTimeSelection();
    spec.add("rm", "", "Remove the selected times, but never 0");
    return runApplication(argc, argv, "List the written times, or remove them.", spec, [](const Options& options) {
        const Case theCase = options.openCase();
        std::optional<RunLock> lock;  // a run that goes on needs its times
        if (options.found("rm")) lock.emplace(theCase.root(), "pfemListTimes");
        bool removed = false;
        for (const auto& time : selectTimes(theCase, options)) {
            if (options.found("rm") && time.value == 0) continue;
            std::cout << time.name << '\n';
            if (!options.found("rm")) continue;
            std::error_code error;
            removeTime(theCase.root(), time.name, error);
            if (error)
                throw UserError("cannot remove \"" + theCase.time(time.name).string() + "\": " + error.message());
            removed = true;
        }
        if (removed) writeSeries(theCase.root());
        return 0;
    });
}
