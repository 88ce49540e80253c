#include "solver/startNumbers.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>

#include "case/timeFolders.hpp"
#include "dictionary/print.hpp"
#include "solver/controls.hpp"

namespace pfem {

namespace {

/// "convergence.tolU" -> "0.0001"
std::map<std::string, std::string> defaults() {
    std::map<std::string, std::string> values;
    const auto collect = [&](const std::string& scope, auto part) {
        entriesDetail::Describer describer;
        part.entries(describer);
        for (const auto& row : describer.rows) values[scope + row.name] = row.defaultValue;
    };
    Controls controls;
    collect("", controls.integration);
    collect("timeIntegration.", controls.timeIntegration);
    collect("convergence.", controls.convergence);
    collect("momentum.", controls.momentum);
    collect("continuity.", controls.continuity);
    collect("solid.", controls.solid);
    collect("remeshing.", controls.remeshing);
    return values;
}

bool sameValue(const std::string& a, const std::string& b) {
    const auto x = asNumber(a), y = asNumber(b);
    return a == b || (x && y && *x == *y);
}

using Wanted = std::function<bool(const std::string& key, const std::string& value)>;

void list(const Dictionary& dict, const std::string& scope, const Wanted& wanted, std::string& text) {
    for (const auto& key : dict.keys()) {
        if (dict.isDict(key)) {
            list(dict.subDict(key), scope + key + ".", wanted, text);
            continue;
        }
        std::string value = valueText(dict, key);
        if (!wanted(scope + key, value)) continue;
        if (value.size() > 60) value = value.substr(0, 57) + "...";
        const Location where = dict.where(key);
        text += fmt::format("    {}:{} {} {}\n", where.file, where.line, scope + key, value);
    }
}

void list(const std::filesystem::path& file, const Wanted& wanted, std::string& text) {
    try {
        if (std::filesystem::exists(file)) list(Dictionary::read(file), "", wanted, text);
    } catch (const UserError&) {  // edited since it was read
    }
}

}  // namespace

std::string startNumbers(const Case& theCase) {
    std::string text;
    const auto plain = [](const std::string& key, const std::string&) {
        return !key.ends_with("type") && key != "dimensions";
    };
    for (const char* file : {"materials", "g", "boundaryConditions"}) list(theCase.constant(file), plain, text);
    const auto step = [](const std::string& key, const std::string&) {
        return key == "deltaT" || key == "adjustTimeStep";
    };
    list(theCase.controlDict(), step, text);
    const auto other = [known = defaults()](const std::string& key, const std::string& value) {
        const auto found = known.find(key);
        return found != known.end() && !sameValue(found->second, value);
    };
    list(theCase.system("pfemSolution"), other, text);
    list(theCase.system("meshDict"), plain, text);
    return text;
}

}  // namespace pfem
