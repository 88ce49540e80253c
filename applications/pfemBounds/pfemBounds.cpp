// One case computed with nodal and with elemental integration on one or more meshes: a band for every probe.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "application/optionValues.hpp"
#include "application/runApplication.hpp"
#include "base/atomicFile.hpp"
#include "bounds/plotScript.hpp"
#include "bounds/report.hpp"
#include "bounds/runTwin.hpp"
#include "case/interrupt.hpp"
#include "functions/functionEntries.hpp"
#include "mesher/space/readSpaceDict.hpp"
#include "study/draw.hpp"

using namespace pfem;

namespace {

OptionsSpec boundsOptions() {
    OptionsSpec spec;
    spec.add("sizes", "list",
             "Mesh sizes, e.g. '(0.006 0.004)' (default: meshSize of system/meshDict; with -noRun all there are)");
    spec.add("endTime", "time", "End of the runs and of the comparison [s] (default: the case's endTime)");
    spec.add("functions", "list", "Functions whose tables are compared, e.g. '(tip)' (default: all of type probes)");
    spec.add("quantities", "list", "Only these, e.g. '(tip_D_x)' (default: all that change)");
    spec.add("reference", "dir", "A finer case with the same probes, drawn over the band");
    spec.add("inside", "part",
             "Exit code 1 when the reference is inside a band for less of the time, e.g. 0.9 (default 0)");
    spec.add("folder", "name", "Where the cases <integration>-<mesh size> are (default 'bounds')");
    spec.add("noRun", "", "Read what is there, run nothing");
    return spec.add("overwrite", "", "Remove the results of these cases and run them again");
}

/// The twins that the options ask for, coarse to fine, nodal before elemental.
std::vector<TwinCase> twinsOf(const Case& theCase, const Options& options) {
    const std::string folder = options.get("folder", "bounds");
    std::vector<double> sizes;
    if (options.found("sizes"))
        sizes = optionValue<std::vector<double>>(options, "sizes", "a list: '(0.006 0.004)'");
    else
        sizes = options.found("noRun") ? sizesIn(theCase.root() / folder) : std::vector{meshSizeOf(theCase)};
    auto twins = twinCases(theCase, folder, sizes);
    if (twins.empty())
        throw UserError(fmt::format("no cases nodal-<mesh size> and elemental-<mesh size> in \"{}\"", folder));
    return twins;
}

std::vector<std::string> functionNames(const Case& theCase, const Options& options) {
    if (options.found("functions"))
        return optionValue<std::vector<std::string>>(options, "functions", "a list: '(tip)'");
    const Dictionary control = Dictionary::read(theCase.controlDict());
    std::vector<std::string> names;
    for (const auto& entry : functionEntries(control))
        if (entry.get("enabled", true) && entry.get<std::string>("type", "") == "probes")
            names.push_back(entry.keyword());
    if (names.empty()) throw UserError("no function of type probes: nothing to compare", control.where("functions"));
    return names;
}

void warnOfUnlikeMeshes(const std::vector<TwinCase>& twins) {
    std::vector<double> sizes;
    std::vector<int> cells;
    for (std::size_t k = 0; k < twins.size(); k += 2) {
        sizes.push_back(twins[k].h);
        cells.push_back(countCells(twins[k].root));
    }
    if (const std::string warning = unlikeMeshes(sizes, cells); !warning.empty())
        std::cerr << "--> PFEM Warning: " << warning << "\n";
}

/// Table, report, script and picture of one quantity.
void write(const std::filesystem::path& folder, const Quantity& quantity) {
    writeQuantity(folder, quantity, 8);
    const std::string report = reportOf(quantity);
    writeAtomically(folder / (quantity.name + ".txt"), report);
    writeAtomically(folder / (quantity.name + ".gp"), plotScript(quantity));
    std::cout << "\n" << report << std::flush;
    drawPicture(folder, quantity.name);
}

/// The quantities of one table of a function in all twins.
std::vector<Quantity> compared(const std::vector<TwinCase>& twins, const std::string& function, const std::string& file,
                               const Options& options, std::optional<double> until) {
    std::vector<TwinHistories> histories;
    for (std::size_t k = 0; k < twins.size(); k += 2)
        histories.push_back({twins[k].h, readHistories(twins[k].root, function, file),
                             readHistories(twins[k + 1].root, function, file)});
    std::vector<ProbeHistory> reference;
    if (options.found("reference")) reference = readHistories(Case(options.get("reference")).root(), function, file);
    auto quantities = quantitiesOf(function, histories, reference, until);
    if (options.found("quantities")) {
        const auto wanted = optionValue<std::vector<std::string>>(options, "quantities", "a list: '(tip_D_x)'");
        std::erase_if(quantities, [&](const Quantity& q) {
            return std::find(wanted.begin(), wanted.end(), q.name) == wanted.end();
        });
    }
    return quantities;
}

void demandPlaneCase(const Case& theCase) {
    const Dictionary mesh = Dictionary::read(theCase.system("meshDict"));
    if (meshDimension(mesh, theCase.root()) == 3)
        throw UserError("pfemBounds compares cases in the plane only; this one is in space", mesh.where());
}

int bounds(const Options& options) {
    const Case theCase = options.openCase();
    demandPlaneCase(theCase);
    std::cout << startBanner(options, theCase);
    std::optional<double> endTime;
    if (options.found("endTime")) endTime = optionValue<double>(options, "endTime", "a time");
    const double wanted =
        options.found("inside") ? optionValue<double>(options, "inside", "a part of the time: 0.9") : 0;
    const auto twins = twinsOf(theCase, options);
    const auto names = functionNames(theCase, options);

    if (!options.found("noRun")) {
        catchInterrupts();
        for (const auto& twin : twins) prepareTwin(theCase, twin, endTime, options.found("overwrite"));
        for (const auto& twin : twins) runTwin(twin, std::cout);
    }
    warnOfUnlikeMeshes(twins);

    const auto folder = theCase.postProcessing("bounds", "0");
    double inside = 1;
    int written = 0;
    for (const auto& name : names)
        for (const auto& file : historyFiles(twins.front().root, name))
            for (const auto& quantity : compared(twins, name, file, options, endTime)) {
                write(folder, quantity);
                inside = std::min(inside, insideOf(quantity));
                ++written;
            }
    if (written == 0) throw UserError("nothing to compare: no such quantity, or none that changes");
    std::cout << fmt::format("\nTables and pictures: \"{}\"\n\nEnd\n\n", folder.string());
    return inside < wanted ? 1 : 0;
}

}  // namespace

int main(int argc, char* argv[]) {
    return runApplication(
        argc, argv,
        "Compute a case with nodal and with elemental integration: lower and upper curve of every probe, "
        "their distance and, from two or more mesh sizes, the limit with its uncertainty.",
        boundsOptions(), bounds);
}
