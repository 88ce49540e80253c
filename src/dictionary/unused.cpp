// What the user wrote and no program read: in OpenFOAM a misspelt keyword has no effect and no message.

#include <ostream>

#include "dictionary/dictionary.hpp"
#include "dictionary/node.hpp"

namespace pfem {

namespace {

std::string suggestion(const DictionaryNode& node, const std::string& key) {
    // First among the keys that were asked for in vain: one of them is what was meant.
    std::vector<std::string> absent, all;
    for (const auto& word : node.lookedUp) {
        if (word == key) continue;  // looked at, not read
        all.push_back(word);
        if (!node.index.contains(word)) absent.push_back(word);
    }
    const std::string near = nearestWord(key, absent);
    return near.empty() ? nearestWord(key, all) : near;
}

void collect(const DictionaryNode& node, std::vector<Unused>& result) {
    for (const auto& entry : node.entries) {
        if (entry.key == headerKey) continue;
        if (!entry.used) {
            if (!entry.inMacro) result.push_back({entry.key, entry.where, suggestion(node, entry.key)});
        } else if (entry.dict) {
            collect(*entry.dict->node(), result);
        } else if (!entry.readWhole) {
            for (const auto& token : entry.tokens) {
                if (token.dict) collect(*token.dict->node(), result);
            }
        }
    }
}

}  // namespace

std::vector<Unused> Dictionary::unused() const {
    std::vector<Unused> result;
    collect(*node_, result);
    return result;
}

void warnUnused(const Dictionary& dictionary, std::ostream& out) {
    for (const auto& entry : dictionary.unused()) {
        out << "--> PFEM Warning: entry '" << entry.key << "' in " << entry.where.file << ':' << entry.where.line
            << " is not used";
        if (!entry.suggestion.empty()) out << " (did you mean '" << entry.suggestion << "'?)";
        out << '\n';
    }
}

}  // namespace pfem
