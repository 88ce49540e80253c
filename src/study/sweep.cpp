#include "study/sweep.hpp"

#include <fmt/format.h>

#include <iostream>
#include <set>

namespace pfem {

namespace {

/// The dictionaries in `key`, with their names. Throws UserError when there is none.
std::vector<Dictionary> namedIn(const Dictionary& dict, const std::string& key, const char* example) {
    if (!dict.found(key)) dict.fatal(key, fmt::format("no '{0}': {0} {{ {1} }}", key, example));
    auto all = dict.dictList(key);
    if (all.empty()) dict.fatal(key, fmt::format("'{0}' is empty: {0} {{ {1} }}", key, example));
    return all;
}

/// Columns of the table: each name once, none of ours.
void addName(std::set<std::string>& names, const std::string& name, const Location& where) {
    if (name.empty() || name.find_first_of(",\"\n") != std::string::npos)
        throw UserError("'" + name + "' cannot be the name of a column", where);
    if (!names.insert(name).second)
        throw UserError("'" + name + "' is already the name of another column of the table", where);
}

void checkEntriesDiffer(const std::vector<Parameter>& parameters) {
    for (std::size_t i = 0; i < parameters.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (parameters[i].file == parameters[j].file && parameters[i].path == parameters[j].path)
                throw UserError(fmt::format("parameters '{}' and '{}' change the same entry", parameters[j].name,
                                            parameters[i].name),
                                parameters[i].where);
}

}  // namespace

Sweep readSweep(const Dictionary& dict) {
    Sweep sweep;
    sweep.where = dict.where();
    readEntries(dict, static_cast<SweepEntries&>(sweep));
    std::set<std::string> names{"case", "state"};
    for (const auto& entry : namedIn(
             dict, "parameters", R"(stiffness { file "constant/materials"; entry "rubber/E"; values (1e6 2e6); })")) {
        sweep.parameters.push_back(readParameter(entry));
        addName(names, entry.keyword(), entry.where());
    }
    for (const auto& entry : namedIn(dict, "results", "tip { function tip; file D; column D_x; value max; }")) {
        sweep.results.push_back(readResult(entry));
        addName(names, entry.keyword(), entry.where());
    }
    checkEntriesDiffer(sweep.parameters);
    if (sweep.method == "latinHypercube" && sweep.samples < 1)
        dict.fatal("samples", "latinHypercube needs the number of cases: samples 12;");
    warnUnused(dict, std::cerr);
    return sweep;
}

}  // namespace pfem
