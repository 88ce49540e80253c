#include "bounds/twinCase.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "dictionary/dictionary.hpp"
#include "io/stateFiles.hpp"
#include "study/caseCopy.hpp"

namespace pfem {

namespace fs = std::filesystem;

std::string TwinCase::name() const { return fmt::format("{}-{}", integration, h); }

std::vector<TwinCase> twinCases(const Case& theCase, const std::string& folder, std::vector<double> sizes) {
    std::sort(sizes.rbegin(), sizes.rend());
    std::vector<TwinCase> twins;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (!(sizes[i] > 0)) throw UserError(fmt::format("the mesh size {} is not positive", sizes[i]));
        if (i > 0 && sizes[i] > 0.99 * sizes[i - 1])
            throw UserError(fmt::format("the mesh sizes {} and {} are hardly different", sizes[i - 1], sizes[i]));
        for (const char* integration : {"nodal", "elemental"}) {
            TwinCase twin{integration, sizes[i], {}};
            twin.root = theCase.root() / folder / twin.name();
            twins.push_back(std::move(twin));
        }
    }
    return twins;
}

std::vector<double> sizesIn(const fs::path& folder) {
    std::vector<double> sizes;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("nodal-")) continue;
        const auto h = asNumber(name.substr(6));
        if (h && fs::is_directory(folder / ("elemental-" + name.substr(6)))) sizes.push_back(*h);
    }
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes;
}

double meshSizeOf(const Case& theCase) { return Dictionary::read(theCase.system("meshDict")).get<double>("meshSize"); }

void prepareTwin(const Case& theCase, const TwinCase& twin, std::optional<double> endTime, bool overwrite) {
    CaseCopy copy{twin.root, {{"system/pfemSolution", {"integration"}, twin.integration}}, {}};
    if (const auto file = theCase.system("pfemSolution");
        fs::exists(file) && Dictionary::read(file).subDictOrEmpty("solid").found("integration"))
        copy.changes.push_back({"system/pfemSolution", {"solid", "integration"}, "asFluid"});
    if (endTime) copy.changes.push_back({"system/controlDict", {"endTime"}, fmt::format("{}", *endTime)});
    makeCopy(theCase, copy, overwrite ? Copying::overwrite : Copying::keep);
}

int countCells(const fs::path& root) {
    const auto times = listTimes(root).complete;
    if (times.empty()) throw UserError(fmt::format("no time folder in \"{}\"", root.string()));
    const auto state = readState<2>(root / times.front().name);
    return state.mesh.fluid.size() + state.mesh.solid.size();
}

}  // namespace pfem
