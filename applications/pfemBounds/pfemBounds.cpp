// One case computed with nodal and with elemental integration on one or more meshes: a band for every probe.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "application/optionValues.hpp"
#include "application/runApplication.hpp"
#include "application/runProgram.hpp"
#include "bounds/plotScript.hpp"
#include "bounds/report.hpp"
#include "bounds/twinCase.hpp"
#include "case/interrupt.hpp"
#include "io/atomicFile.hpp"

using namespace pfem;

namespace {

OptionsSpec boundsOptions() {
    OptionsSpec spec;
    spec.add("sizes", "list", "Mesh sizes, e.g. '(0.006 0.004)' (default: meshSize of system/meshDict; with -noRun all there are)");
    spec.add("endTime", "time", "End of the runs and of the comparison [s] (default: the case's endTime)");
    spec.add("functions", "list", "Functions whose tables are compared, e.g. '(tip)' (default: all of type probes)");
    spec.add("reference", "dir", "A finer case with the same probes, drawn over the band");
    spec.add("inside", "part", "Exit code 1 when the reference is inside a band for less of the time, e.g. 0.9 (default 0)");
    spec.add("folder", "name", "Where the cases <integration>-<mesh size> are (default 'bounds')");
    spec.add("noRun", "", "Read what is there, run nothing");
    return spec.add("overwrite", "", "Remove the results of these cases and run them again");
}

std::vector<std::string> functionNames(const Case& theCase, const Options& options) {
    if (options.found("functions")) return optionValue<std::vector<std::string>>(options, "functions", "a list: '(tip)'");
    const Dictionary control = Dictionary::read(theCase.controlDict());
    const Dictionary& functions = control.subDictOrEmpty("functions");
    std::vector<std::string> names;
    for (const auto& name : functions.keys())
        if (functions.isDict(name) && functions.subDict(name).get<std::string>("type", "") == "probes") names.push_back(name);
    if (names.empty()) throw UserError("no function of type probes: nothing to compare", functions.where());
    return names;
}

/// A program in the twin's folder; what its log says of progress is shown about once a minute.
void runIn(const TwinCase& twin, const std::vector<std::string>& command) {
    const auto log = twin.root / ("log." + std::filesystem::path(command[0]).filename().string());
    int seconds = 0;
    const int code = runProgram(command, twin.root, log, [&] {
        if (++seconds % 15 == 0) std::cout << "    " << lastLineWith(log, "Progress") << "\n" << std::flush;
    });
    if (interrupted()) throw UserError("stopped; the same command goes on from here");
    if (code != 0)
        throw UserError(fmt::format("{} has failed with exit code {}: see \"{}\"", command[0], code, log.string()));
}

void run(const TwinCase& twin) {
    const auto before = reachedTime(twin.root);
    if (before.finished()) {
        std::cout << fmt::format("{}: finished\n", twin.name()) << std::flush;
        return;
    }
    std::cout << fmt::format("{}: from {} to {} s\n", twin.name(), before.latest.value_or(0), before.endTime) << std::flush;
    if (!before.latest) runIn(twin, {siblingProgram("pfemMesh"), "-h", fmt::format("{}", twin.h)});
    runIn(twin, {siblingProgram("pfemFsiFoam")});
    if (!reachedTime(twin.root).finished())
        throw UserError(fmt::format("{} has not reached its endTime: see its log", twin.name()));
}

/// The picture; without gnuplot the script is there for later.
void draw(const std::filesystem::path& folder, const std::string& name) {
    try {
        const auto log = folder / "log.gnuplot";
        std::filesystem::remove(log);
        if (runProgram({"gnuplot", name + ".gp"}, folder, log) != 0)
            std::cerr << "--> PFEM Warning: gnuplot could not draw " << name << ".gp: see \"" << log.string() << "\"\n";
    } catch (const UserError& error) {
        std::cerr << "--> PFEM Warning: no picture: " << error.what() << "; draw it with  gnuplot " << name << ".gp\n";
    }
}

/// Tables, scripts and pictures of one function in postProcessing/bounds/0. The smallest part of the time for which a
/// reference is inside its band; 1 without reference.
double compare(const Case& theCase, const std::vector<TwinCase>& twins, const std::string& function, const Options& options,
               std::optional<double> until) {
    double inside = 1;
    const std::optional<Case> reference =
        options.found("reference") ? std::optional<Case>(Case(options.get("reference"))) : std::nullopt;
    const auto folder = theCase.postProcessing("bounds", "0");
    for (const auto& file : historyFiles(twins.front().root, function)) {
        std::vector<TwinHistories> histories;
        for (std::size_t k = 0; k < twins.size(); k += 2)
            histories.push_back({twins[k].h, readHistories(twins[k].root, function, file),
                                 readHistories(twins[k + 1].root, function, file)});
        const auto finer = reference ? readHistories(reference->root(), function, file) : std::vector<History>{};
        for (const auto& quantity : quantitiesOf(function, histories, finer, until)) {
            writeQuantity(folder, quantity, 8);
            writeAtomically(folder / (quantity.name + ".gp"), plotScript(quantity));
            inside = std::min(inside, insideOf(quantity));
            const std::string report = reportOf(quantity);
            writeAtomically(folder / (quantity.name + ".txt"), report);
            std::cout << "\n" << report << std::flush;
            draw(folder, quantity.name);
        }
    }
    return inside;
}

int bounds(const Options& options) {
    const Case theCase = options.openCase();
    std::cout << startBanner(options, theCase);
    const std::string folder = options.get("folder", "bounds");
    std::optional<double> endTime;
    if (options.found("endTime")) endTime = optionValue<double>(options, "endTime", "a time");
    const double wanted = options.found("inside") ? optionValue<double>(options, "inside", "a part of the time: 0.9") : 0;
    std::vector<double> sizes = options.found("noRun") ? sizesIn(theCase.root() / folder) : std::vector{meshSizeOf(theCase)};
    if (options.found("sizes")) sizes = optionValue<std::vector<double>>(options, "sizes", "a list: '(0.006 0.004)'");
    const auto twins = twinCases(theCase, folder, sizes);
    if (twins.empty()) throw UserError(fmt::format("no cases nodal-<mesh size> and elemental-<mesh size> in \"{}\"", folder));
    const auto names = functionNames(theCase, options);

    if (!options.found("noRun")) {
        catchInterrupts();
        for (const auto& twin : twins) prepareTwin(theCase, twin, endTime, options.found("overwrite"));
        for (const auto& twin : twins) run(twin);
    }
    std::vector<int> cells;
    for (std::size_t k = 0; k < twins.size(); k += 2) cells.push_back(countCells(twins[k].root));
    std::sort(sizes.rbegin(), sizes.rend());
    if (const std::string warning = unlikeMeshes(sizes, cells); !warning.empty())
        std::cerr << "--> PFEM Warning: " << warning << "\n";
    double inside = 1;
    for (const auto& name : names) inside = std::min(inside, compare(theCase, twins, name, options, endTime));
    std::cout << fmt::format("\nTables and pictures: \"{}\"\n\nEnd\n\n", theCase.postProcessing("bounds", "0").string());
    return inside < wanted ? 1 : 0;
}

}  // namespace

int main(int argc, char* argv[]) {
    return runApplication(argc, argv,
                          "Compute a case with nodal and with elemental integration: lower and upper curve of every probe, "
                          "their distance and, from two or more mesh sizes, the limit with its uncertainty",
                          boundsOptions(), bounds);
}
