// Sample probes over the written times: those of system/controlDict, of another dictionary, or a point.

#include <fmt/format.h>

#include <iostream>

#include "application/dimension.hpp"
#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "base/error.hpp"
#include "functions/postProcess.hpp"

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
        fmt::format("functions {{ {} {{ type probes; fields {}; probeLocations ({}); fixedLocations {}; }} }}",
                    options.get("name", "point"), options.get("fields", "(U p)"), options.get("point"),
                    options.found("moving") ? "false" : "true"),
        "command line");
}

template <int Dim>
void run(const Case& theCase, const Options& options, const std::vector<TimeFolder>& times) {
    const Dictionary dict = functionsOf(theCase, options);
    FunctionObjects<Dim> probes(theCase, dict, times.front().name, 6,
                                [](const Dictionary& entry) { return entry.get<std::string>("type") == "probes"; });
    if (probes.size() == 0) throw UserError("no function of type probes in \"" + dict.name() + "\"");
    postProcess(theCase, probes, times, options.found("overwrite"), std::cout);
}

}  // namespace

int main(int argc, char** argv) {
    return runApplication(argc, argv,
                          "Values at points over the written times, in postProcessing/<name>/<first time>/<field>.",
                          probeOptions(), [](const Options& options) {
                              const Case theCase = options.openCase();
                              const auto times = selectTimes(theCase, options);
                              withDimension(theCase.time(times.front().name),
                                            [&](auto dim) { run<decltype(dim)::value>(theCase, options, times); });
                              std::cout << "\nEnd\n\n";
                              return 0;
                          });
}
