#include "dictionary/flatEntries.hpp"

#include "dictionary/node.hpp"
#include "dictionary/print.hpp"

namespace pfem {

namespace {

/// The dictionaries of `( a {...} b {...} )`; none when there is something else in the list.
std::vector<Dictionary> namedIn(const Tokens& tokens) {
    std::vector<Dictionary> named;
    if (tokens.size() < 4 || tokens.size() % 2 != 0 || !tokens.front().is('(') || !tokens.back().is(')')) return {};
    for (std::size_t i = 1; i + 1 < tokens.size(); i += 2) {
        if (tokens[i].dict || !tokens[i + 1].dict || tokens[i + 1].dict->node()->entries.empty()) return {};
        named.push_back(*tokens[i + 1].dict);
    }
    return named;
}

void collect(const Dictionary& dictionary, const std::string& scope, std::map<std::string, std::string>& flat) {
    for (const auto& entry : dictionary.node()->entries) {
        if (scope.empty() && entry.key == headerKey) continue;
        const std::string path = scope + entry.key;
        const auto named = namedIn(entry.tokens);
        for (const auto& dict : named) collect(dict, path + "." + dict.keyword() + ".", flat);
        if (!named.empty()) continue;
        if (!entry.dict)
            flat[path] = spelling(entry.tokens);
        else if (entry.dict->node()->entries.empty())
            flat[path] = "{}";
        else
            collect(*entry.dict, path + ".", flat);
    }
}

}  // namespace

std::map<std::string, std::string> flatEntries(const Dictionary& dictionary) {
    std::map<std::string, std::string> flat;
    collect(dictionary, "", flat);
    return flat;
}

std::set<std::string> filesOf(const Dictionary& dictionary) {
    std::set<std::string> files{dictionary.where().file};
    for (const auto& entry : dictionary.node()->entries) {
        files.insert(entry.where.file);
        for (const auto& token : entry.tokens)
            if (token.file) files.insert(*token.file);
        if (entry.dict) files.merge(filesOf(*entry.dict));
    }
    return files;
}

std::string differences(const std::map<std::string, std::string>& before, const std::map<std::string, std::string>& now,
                        const std::string& indent) {
    std::string text;
    for (const auto& [key, value] : now) {
        const auto old = before.find(key);
        if (old == before.end())
            text += indent + key + ": " + value + ", not there before\n";
        else if (old->second != value)
            text += indent + key + ": " + old->second + " -> " + value + "\n";
    }
    for (const auto& [key, value] : before)
        if (now.count(key) == 0) text += indent + key + ": removed (was " + value + ")\n";
    return text;
}

}  // namespace pfem
