#include "study/sweepCases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "functions/functionEntries.hpp"
#include "study/sampling.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// Not in a folder yet: nothing has run.
Reached reachedIn(const fs::path& root) {
    return fs::exists(root / "system" / "controlDict") ? reachedTime(root) : Reached{};
}

/// A cell of a table: strings without their quotes; in quotes where a comma would part it.
std::string cell(std::string text) {
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, "\"");
    return '"' + text + '"';
}

std::string firstCells(const SweepCase& one) {
    std::string text = std::to_string(one.number);
    for (const auto& value : one.values) text += "," + cell(value);
    return text;
}

std::string titles(const Sweep& sweep) {
    std::string text = "case";
    for (const auto& parameter : sweep.parameters) text += "," + parameter.name;
    return text;
}

}  // namespace

std::string SweepCase::name() const { return fmt::format("case {}", number); }

std::vector<SweepCase> sweepCases(const Sweep& sweep, const fs::path& folder) {
    std::vector<SweepCase> cases;
    for (auto& values : sampleCases(sweep)) {
        const int number = static_cast<int>(cases.size()) + 1;
        cases.push_back({number, std::move(values), folder / std::to_string(number)});
    }
    return cases;
}

void checkSweep(const Case& theCase, const Sweep& sweep) {
    for (const auto& parameter : sweep.parameters) checkParameter(theCase, parameter);
    std::vector<std::string> functions;
    for (const auto& entry : functionEntries(Dictionary::read(theCase.controlDict())))
        functions.push_back(entry.keyword());
    for (const auto& result : sweep.results)
        if (std::find(functions.begin(), functions.end(), result.function) == functions.end())
            throw UserError(fmt::format("result '{}': {}", result.name,
                                        notValid(result.function, "function of controlDict", functions)),
                            result.where);
}

void makeSweepCase(const Case& theCase, const Sweep& sweep, const SweepCase& one, Copying how) {
    CaseCopy copy{one.root, {}, {"endTime", "stopAt", "purgeWrite", "runTimeModifiable"}};
    for (std::size_t k = 0; k < one.values.size(); ++k)
        copy.changes.push_back({sweep.parameters[k].file, sweep.parameters[k].path, one.values[k]});
    makeCopy(theCase, copy, how);
}

std::vector<SweepRow> gather(const Sweep& sweep, const std::vector<SweepCase>& cases) {
    std::vector<SweepRow> rows;
    for (const auto& one : cases) {
        SweepRow row{one, reachedIn(one.root), {}};
        for (const auto& result : sweep.results)
            row.results.push_back(row.reached.finished() ? valueIn(result, one.root, row.reached.endTime * (1 + 1e-9))
                                                         : std::numeric_limits<double>::quiet_NaN());
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string casesTable(const Sweep& sweep, const std::vector<SweepCase>& cases) {
    std::string text = titles(sweep) + "\n";
    for (const auto& one : cases) text += firstCells(one) + "\n";
    return text;
}

std::string resultsTable(const Sweep& sweep, const std::vector<SweepRow>& rows) {
    std::string text = titles(sweep);
    for (const auto& result : sweep.results) text += "," + result.name;
    text += ",state\n";
    for (const auto& row : rows) {
        text += firstCells(row.theCase);
        for (const double value : row.results) text += std::isnan(value) ? "," : fmt::format(",{:.10g}", value);
        text += row.reached.finished() ? ",finished\n" : ",unfinished\n";
    }
    return text;
}

}  // namespace pfem
