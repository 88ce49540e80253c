#include "case/settings.hpp"

#include <sstream>

#include "base/atomicFile.hpp"
#include "dictionary/flatEntries.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

constexpr const char* kept = ".pfemSettings";

/// Lines "key<tab>value"; no line breaks in either.
std::string toText(const Settings& settings) {
    std::string text;
    for (const auto& [key, value] : settings) {
        std::string line = key + "\t" + value;
        for (char& c : line)
            if (c == '\n') c = ' ';
        text += line + "\n";
    }
    return text;
}

Settings fromText(const std::string& text) {
    Settings settings;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (const auto tab = line.find('\t'); tab != std::string::npos)
            settings[line.substr(0, tab)] = line.substr(tab + 1);
    return settings;
}

}  // namespace

Settings currentSettings(const Case& theCase) {
    Settings settings;
    for (const char* file : {"constant/boundaryConditions", "constant/g", "constant/materials", "system/controlDict",
                             "system/pfemSolution"}) {
        if (!fs::exists(theCase.root() / file)) continue;
        for (const auto& [key, value] : flatEntries(Dictionary::read(theCase.root() / file)))
            settings[file + std::string(" ") + key] = value;
    }
    return fromText(toText(settings));
}

std::string settingChanges(const Case& theCase, const Settings& now) {
    const fs::path file = theCase.root() / kept;
    return fs::exists(file) ? differences(fromText(readText(file)), now) : "";
}

void keepSettings(const Case& theCase, const Settings& now) {
    const fs::path file = theCase.root() / kept;
    if (!fs::exists(file) || fromText(readText(file)) != now) writeAtomically(file, toText(now));
}

}  // namespace pfem
