#include "dictionary/print.hpp"

#include <ostream>

#include "dictionary/node.hpp"

namespace pfem {

namespace {

std::string keyText(const DictionaryEntry& entry) { return entry.quoted ? '"' + entry.key + '"' : entry.key; }

}  // namespace

void print(std::ostream& out, const Dictionary& dictionary, int indent) {
    const std::string space(static_cast<std::size_t>(indent), ' ');
    for (const auto& entry : dictionary.node()->entries) {
        std::string key = keyText(entry);
        if (entry.dict) {
            out << space << key << '\n' << space << "{\n";
            print(out, *entry.dict, indent + 4);
            out << space << "}\n";
            continue;
        }
        if (!entry.tokens.empty()) key.resize(std::max<std::size_t>(16, key.size() + 1), ' ');
        out << space << key << spelling(entry.tokens) << ";\n";
    }
}

std::string oneLine(const Dictionary& dictionary) {
    std::string text;
    for (const auto& entry : dictionary.node()->entries) {
        text += keyText(entry);
        text += entry.dict ? " { " : entry.tokens.empty() ? "" : " ";
        text += entry.dict ? oneLine(*entry.dict) : spelling(entry.tokens);
        text += entry.dict ? "} " : "; ";
    }
    return text;
}

std::string valueText(const Dictionary& dictionary, const std::string& key) {
    const DictionaryEntry* entry = dictionary.node()->find(key);
    if (!entry) dictionary.reader(key);  // reports that it is absent
    return entry->dict ? "{ " + oneLine(*entry->dict) + "}" : spelling(entry->tokens);
}

}  // namespace pfem
