// Sample probes over the written times: those of system/controlDict, of another dictionary, or a point.

#include <fmt/format.h>

#include <filesystem>

#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "base/error.hpp"
#include "functions/functionObjects.hpp"
#include "io/stateFiles.hpp"

using namespace pfem;

namespace {

OptionsSpec probeOptions() {
    OptionsSpec spec;
    spec.addTimeSelection();
    spec.add("dict", "file", "Read the functions from this dictionary instead of system/controlDict");
    spec.add("point", "vector", "Sample here, e.g. '(0.1 0.2 0)', instead of reading a dictionary");
    spec.add("fields", "list", "Fields for -point (default '(U p)')");
    spec.add("name", "word", "Folder in postProcessing for -point (default 'point')");
    spec.add("moving", "", "The point of -point is attached to the material");
    return spec.add("overwrite", "", "Replace tables that are already there");
}

/// The dictionary with `functions` that the options ask for.
Dictionary functionsOf(const Case& theCase, const Options& options) {
    if (!options.found("point")) return Dictionary::read(options.get("dict", theCase.controlDict().string()));
    return Dictionary::parse(
        fmt::format(
            "functions {{ {} {{ type probes; fields {}; probeLocations ({}); fixedLocations {}; }} }}",
            options.get("name", "point"), options.get("fields", "(U p)"), options.get("point"),
            options.found("moving") ? "false" : "true"),
        "command line");
}

/// Tables of the run itself are denser than the written times: do not lose them by accident.
void protectTables(const Case& theCase, const FunctionObjects<2>& probes, const std::string& startName) {
    for (const auto& name : probes.names()) {
        const auto folder = theCase.postProcessing(name, startName);
        if (std::filesystem::exists(folder))
            throw UserError("\"" + folder.string() + "\" is already there: use -overwrite to replace it");
    }
}

}  // namespace

int main(int argc, char** argv) {
    return runApplication(
        argc, argv, "Values at points over the written times, in postProcessing/<name>/<first time>/<field>.",
        probeOptions(), [](const Options& options) {
            const Case theCase = options.openCase();
            const auto times = selectTimes(theCase, options);
            const Dictionary dict = functionsOf(theCase, options);
            FunctionObjects<2> probes(theCase, dict, times.front().name, 6, "probes");
            if (probes.size() == 0) throw UserError("no function of type probes in \"" + dict.name() + "\"");

            if (!options.found("overwrite")) protectTables(theCase, probes, times.front().name);
            probes.prepare(readState<2>(theCase.time(times.front().name)));
            for (const auto& time : times) {
                fmt::print("Time = {}\n", time.name);
                probes.executeAll(readState<2>(theCase.time(time.name)));
            }
            fmt::print("\nEnd\n\n");
            return 0;
        });
}
