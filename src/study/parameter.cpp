#include "study/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dictionary/flatEntries.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// The names between the slashes.
std::vector<std::string> namesIn(const std::string& entry) {
    std::vector<std::string> names{""};
    for (const char c : entry) {
        if (c == '/')
            names.emplace_back();
        else
            names.back() += c;
    }
    return names;
}

/// The elements of a list as they are written: numbers, words, strings, lists in brackets.
std::vector<std::string> elementsOf(const Dictionary& dict, const std::string& key) {
    std::vector<std::string> elements;
    TokenReader reader = dict.reader(key);
    reader.list([&] {
        Tokens tokens;
        int depth = 0;
        do {
            if (reader.atEnd()) reader.fatal("a bracket is not closed");
            tokens.push_back(reader.next());
            depth += tokens.back().is('(') - tokens.back().is(')');
        } while (depth > 0);
        elements.push_back(spelling(tokens));
    });
    reader.end();
    return elements;
}

std::string withSlashes(std::string entry) {
    std::replace(entry.begin(), entry.end(), '.', '/');
    return entry;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const auto& word : words) text += "\n    " + word;
    return text;
}

[[noreturn]] void unknown(const Parameter& parameter, const std::string& message, const std::string& word,
                          const std::vector<std::string>& valid) {
    const std::string near = nearestWord(word, valid);
    throw UserError(fmt::format("parameter '{}': {}{}. There are:{}", parameter.name, message,
                                near.empty() ? "" : " (did you mean '" + near + "'?)", listed(valid)),
                    parameter.where);
}

void checkRange(const Dictionary& dict, const Parameter& parameter) {
    const auto& range = parameter.range;
    if (range.size() != 2 || !(range[0] < range[1]))
        dict.fatal("range", "range must be two numbers, the least first: (0.004 0.008)");
    if (parameter.isLog() && !(range[0] > 0)) dict.fatal("range", "with scale log the range must be above 0");
}

}  // namespace

std::vector<EntryDescription> describeParameter() {
    auto rows = describeEntries<ParameterEntries>();
    rows.insert(rows.begin() + 2, {"values", "list", "as the entry", "optional",
                                   "numbers, words or lists in brackets: (1e6 2e6); or a range", ""});
    return rows;
}

double Parameter::at(double part) const {
    if (part <= 0) return range[0];
    if (part >= 1) return range[1];
    return isLog() ? range[0] * std::pow(range[1] / range[0], part) : range[0] + part * (range[1] - range[0]);
}

double Parameter::partOf(double number) const {
    return isLog() ? std::log(number / range[0]) / std::log(range[1] / range[0])
                   : (number - range[0]) / (range[1] - range[0]);
}

Parameter readParameter(const Dictionary& dict) {
    Parameter parameter;
    parameter.name = dict.keyword();
    parameter.where = dict.where();
    readEntries(dict, static_cast<ParameterEntries&>(parameter));
    parameter.path = namesIn(parameter.entry);
    if (dict.found("values")) parameter.values = elementsOf(dict, "values");
    if (dict.found("values") == dict.found("range"))
        throw UserError(fmt::format("parameter '{}' needs either values (1 2 3); or range (1 3);", parameter.name),
                        parameter.where);
    if (dict.found("values") && parameter.values.empty()) dict.fatal("values", "values must not be empty");
    if (dict.found("range")) checkRange(dict, parameter);
    return parameter;
}

void checkParameter(const Case& theCase, const Parameter& parameter) {
    const auto sources = sourcesOf(theCase);
    const fs::path file = fs::path(parameter.file).lexically_normal();
    std::vector<std::string> files;
    for (const auto& source : sources) files.push_back(source.string());
    if (std::find(sources.begin(), sources.end(), file) == sources.end())
        unknown(parameter, "\"" + parameter.file + "\" is no file from which the case's dictionaries come",
                parameter.file, files);
    std::vector<std::string> entries;
    for (const auto& [key, value] : flatEntries(Dictionary::read(theCase.root() / file)))
        entries.push_back(withSlashes(key));
    const std::string wanted = withSlashes(parameter.entry);
    if (std::find(entries.begin(), entries.end(), wanted) == entries.end())
        unknown(parameter, fmt::format("\"{}\" has no entry '{}'", parameter.file, parameter.entry), wanted, entries);
    Dictionary around = Dictionary::read(theCase.root() / file);
    for (std::size_t i = 0; i + 1 < parameter.path.size(); ++i) around = Dictionary(around.subDict(parameter.path[i]));
    const fs::path place = around.where(parameter.path.back()).file;
    if (fs::weakly_canonical(place) != fs::weakly_canonical(theCase.root() / file))
        throw UserError(
            fmt::format("parameter '{}': entry '{}' is not written in \"{}\" but in \"{}\", which that includes",
                        parameter.name, parameter.entry, parameter.file, place.string()),
            parameter.where);
}

}  // namespace pfem
