// Function objects over the written times: those of system/controlDict, of another dictionary, or by their
// type.

#include <algorithm>
#include <iostream>
#include <optional>

#include "application/dimension.hpp"
#include "application/optionValues.hpp"
#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "case/runLock.hpp"
#include "functions/functionEntries.hpp"
#include "functions/postProcess.hpp"

using namespace pfem;

namespace {

OptionsSpec postProcessOptions() {
    OptionsSpec spec;
    spec.addTimeSelection();
    spec.add("func", "name(s)",
             "Only this function, or '(a b ...)': names in `functions`, or a type that needs no entries");
    spec.add("dict", "file", "Read the functions from this dictionary instead of system/controlDict");
    return spec.add("overwrite", "", "Replace tables that are already there");
}

std::vector<std::string> wantedNames(const Options& options) {
    if (!options.found("func")) return {};
    if (options.get("func").starts_with("("))
        return optionValue<std::vector<std::string>>(options, "func", "a name or '(name name ...)'");
    return {options.get("func")};
}

/// `functions` of the dictionary; when a wanted name is none of them but a type, one function of that type.
Dictionary functionsOf(const Case& theCase, const Options& options, const std::vector<std::string>& wanted) {
    Dictionary dict = Dictionary::read(options.get("dict", theCase.controlDict().string()));
    std::vector<std::string> names;
    for (const auto& entry : functionEntries(dict)) names.push_back(entry.keyword());
    const auto types = functionTypes();
    for (const auto& name : wanted) {
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        if (wanted.size() == 1 && std::find(types.begin(), types.end(), name) != types.end())
            return Dictionary::parse("functions { " + name + " { type " + name + "; } }", "-func " + name);
        throw UserError(notValid(name, "function", names) +
                        "\n\nIts type alone is enough for functions without entries, one at a time; " + "types are " +
                        fmt::format("{}", fmt::join(types, " ")));
    }
    return dict;
}

/// All wanted functions over the times.
template <int Dim>
void run(const Case& theCase, const Options& options, const std::vector<TimeFolder>& times) {
    const auto wanted = wantedNames(options);
    const Dictionary dict = functionsOf(theCase, options, wanted);
    FunctionObjects<Dim> functions(theCase, dict, times.front().name, 6, [&](const Dictionary& entry) {
        return wanted.empty() || std::find(wanted.begin(), wanted.end(), entry.keyword()) != wanted.end();
    });
    if (functions.size() == 0) throw UserError("there is no enabled function in \"" + dict.name() + "\"");
    for (const auto& entry : functionEntries(dict)) warnUnused(entry, std::cerr);
    postProcess(theCase, functions, times, options.found("overwrite"), std::cout);
}

}  // namespace

int main(int argc, char** argv) {
    return runApplication(
        argc, argv, "Function objects over the written times, in postProcessing/<name>/<first time>.",
        postProcessOptions(), [](const Options& options) {
            const Case theCase = options.openCase();
            std::optional<RunLock> lock;  // tables of a running job must not be replaced under its hands
            if (options.found("overwrite")) lock.emplace(theCase.root(), options.program());
            const auto times = selectTimes(theCase, options);
            withDimension(theCase.time(times.front().name),
                          [&](auto dim) { run<decltype(dim)::value>(theCase, options, times); });
            std::cout << "\nEnd\n\n";
            return 0;
        });
}
