#include "bounds/twinCase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "dictionary/dictionary.hpp"
#include "dictionary/print.hpp"
#include "io/stateFiles.hpp"
#include "io/textHeader.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// The dictionary's text with all macros and includes resolved, so that it says the same in another folder.
std::string resolved(const fs::path& file, const std::string& changes) {
    std::ostringstream text;
    if (fs::exists(file)) print(text, Dictionary::read(file));
    std::ostringstream changed;
    print(changed, Dictionary::parse(text.str() + changes, file.string()));
    return changed.str() + "\n" + dictionaryEndLine();
}

std::string changesOf(const TwinCase& twin, const fs::path& file, std::optional<double> endTime) {
    if (file == "system/pfemSolution") return "integration " + twin.integration + ";\n";
    if (file != "system/controlDict") return "";
    return "startFrom latestTime;\n" + (endTime ? fmt::format("endTime {};\n", *endTime) : "");
}

bool isDictionary(const fs::path& file) {
    static const std::set<std::string> names{"constant/materials",  "constant/g",      "constant/boundaryConditions",
                                             "system/pfemSolution", "system/meshDict", "system/controlDict"};
    return names.contains(file.string());
}

/// Files of constant/ and system/, relative to the case; pfemSolution in any case.
std::vector<fs::path> filesOf(const fs::path& root) {
    std::set<fs::path> files{"system/pfemSolution"};
    for (const char* folder : {"constant", "system"}) {
        std::error_code error;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder, error))
            if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), root));
    }
    return {files.begin(), files.end()};
}

void write(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw UserError("cannot make the folder: " + error.message(), {file.parent_path().string(), 0});
    writeAtomically(file, text);
}

}  // namespace

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
    if (overwrite) fs::remove_all(twin.root);
    const bool hasResults = !listTimes(twin.root).complete.empty();
    for (const auto& file : filesOf(theCase.root())) {
        const std::string text = isDictionary(file) ? resolved(theCase.root() / file, changesOf(twin, file, endTime))
                                                    : readText(theCase.root() / file);
        const fs::path copy = twin.root / file;
        const bool same = fs::exists(copy) && readText(copy) == text;
        if (hasResults && !same && file != "system/controlDict")
            throw UserError(fmt::format("\"{}\" has results of another \"{}\": remove that folder, or use -overwrite",
                                        twin.root.string(), file.string()));
        if (!same) write(copy, text);
    }
}

bool Reached::finished() const { return latest && *latest >= endTime * (1 - 1e-9); }

Reached reachedTime(const fs::path& root) {
    Reached reached;
    reached.endTime = Dictionary::read(root / "system" / "controlDict").get<double>("endTime");
    const auto times = listTimes(root).complete;
    if (!times.empty()) reached.latest = times.back().value;
    return reached;
}

int countCells(const fs::path& root) {
    const auto times = listTimes(root).complete;
    if (times.empty()) throw UserError(fmt::format("no time folder in \"{}\"", root.string()));
    const auto state = readState<2>(root / times.front().name);
    return state.mesh.fluid.size() + state.mesh.solid.size();
}

}  // namespace pfem
