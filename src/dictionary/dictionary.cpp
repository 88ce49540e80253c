#include "dictionary/dictionary.hpp"

#include <algorithm>

#include "dictionary/dimensions.hpp"
#include "dictionary/node.hpp"
#include "dictionary/parser.hpp"

namespace pfem {

Dictionary readWith(const Overlay& changed, const std::filesystem::path& file) {
    auto node = makeNode(nullptr, file.string(), {file.string(), 1});
    Parser parser(changed);
    parser.readFile(file, node);
    return Dictionary(node);
}

Dictionary Dictionary::read(const std::filesystem::path& file) { return readWith({}, file); }

Dictionary Dictionary::parse(const std::string& text, const std::string& name) {
    auto node = makeNode(nullptr, name, {name, 1});
    Parser parser;
    parser.readText(text, name, node);
    return Dictionary(node);
}

Dictionary::Dictionary() : node_(makeNode(nullptr, "", {})) {}
Dictionary::Dictionary(std::shared_ptr<DictionaryNode> node) : node_(std::move(node)) {}

const std::string& Dictionary::name() const { return node_->name; }
std::string Dictionary::keyword() const { return node_->keyword; }
Location Dictionary::where() const { return node_->where; }

Location Dictionary::where(const std::string& key) const {
    const DictionaryEntry* entry = node_->find(key);
    return entry ? entry->where : node_->where;
}

bool Dictionary::found(const std::string& key) const {
    DictionaryEntry* entry = find(key);
    if (entry) entry->used = true;
    return entry != nullptr;
}

bool Dictionary::isDict(const std::string& key) const {
    const DictionaryEntry* entry = find(key);
    return entry && entry->dict;
}

std::vector<std::string> Dictionary::keys() const {
    std::vector<std::string> result;
    for (const auto& entry : node_->entries) {
        if (!entry.pattern && entry.key != headerKey) result.push_back(entry.key);
    }
    return result;
}

namespace {

/// A forgotten semicolon makes the next entry part of the value before it: `a 1\n b 2;`
const Token* swallowedKey(const DictionaryNode& node, const std::string& key) {
    for (const auto& entry : node.entries) {
        int depth = 0;
        for (const auto& token : entry.tokens) {
            if (token.is('(') || token.is('{')) ++depth;
            if (token.is(')') || token.is('}')) --depth;
            const bool first = &token == &entry.tokens.front();
            if (depth == 0 && !first && token.firstOnLine && token.isWord() && token.text == key) return &token;
        }
    }
    return nullptr;
}

}  // namespace

DictionaryEntry* Dictionary::find(const std::string& key) const {
    node_->lookedUp.insert(key);
    DictionaryEntry* entry = node_->find(key);
    const Token* swallowed = entry ? nullptr : swallowedKey(*node_, key);
    if (swallowed) {
        throw UserError("Entry '" + key + "' not found in dictionary \"" + name() + "\": '" + key +
                            "' stands in the value of the entry before it; missing ';' before line " +
                            std::to_string(swallowed->line) + " ?",
                        swallowed->where());
    }
    return entry;
}

DictionaryEntry& Dictionary::demand(const std::string& key) const {
    DictionaryEntry* entry = find(key);
    if (entry) {
        entry->used = true;
        return *entry;
    }
    std::string message = "Entry '" + key + "' not found in dictionary \"" + name() + '"';
    const std::string near = nearestWord(key, keys());
    if (!near.empty()) {
        message += " (did you mean '" + near + "' on line " + std::to_string(where(near).line) + "?)";
    }
    throw UserError(message, node_->where);
}

const Dictionary& Dictionary::subDict(const std::string& key) const {
    const DictionaryEntry& entry = demand(key);
    if (!entry.dict) fatal(key, "Entry '" + key + "' is not a sub-dictionary in dictionary \"" + name() + '"');
    return *entry.dict;
}

const Dictionary& Dictionary::subDictOrEmpty(const std::string& key) const {
    if (has(key)) return subDict(key);
    auto& empty = node_->empties[key];
    if (!empty) empty = std::make_shared<Dictionary>(makeNode(node_, key, node_->where));
    return *empty;
}

std::vector<Dictionary> Dictionary::dictList(const std::string& key) const {
    DictionaryEntry& entry = demand(key);
    std::vector<Dictionary> result;
    if (entry.dict) {
        for (const auto& name : entry.dict->keys()) result.push_back(entry.dict->subDict(name));
        return result;
    }
    TokenReader tokens(node_, entry.tokens, key, entry.where);
    tokens.list([&] {
        if (tokens.peek().kind != Token::Kind::dictionary) tokens.read<std::string>();  // the name
        result.push_back(tokens.read<Dictionary>());
    });
    tokens.end();
    return result;
}

std::string Dictionary::choice(const std::string& key, const std::vector<std::string>& valid) const {
    TokenReader tokens = reader(key);
    const Token first = tokens.peek();
    std::string word = first.isNumber() ? tokens.next().text : tokens.read<std::string>();
    if (std::find(valid.begin(), valid.end(), word) == valid.end()) fatal(key, notValid(word, key, valid));
    tokens.end();
    return word;
}

std::string Dictionary::choice(const std::string& key, const std::vector<std::string>& valid,
                               const std::string& defaultWord) const {
    return has(key) ? choice(key, valid) : defaultWord;
}

double Dictionary::dimensioned(const std::string& key, const std::array<double, 7>& dimensions) const {
    TokenReader tokens = reader(key);
    if (tokens.peek().isWord()) tokens.next();  // old spelling: the name again
    if (tokens.peek().is('[')) {
        const Dimensions given = readDimensions(tokens);
        if (!sameDimensions(given, dimensions)) {
            fatal(key, "Dimensions " + toString(given) + " of entry '" + key + "' should be " + toString(dimensions));
        }
    }
    const auto value = tokens.read<double>();
    tokens.end();
    return value;
}

double Dictionary::dimensioned(const std::string& key, const std::array<double, 7>& dimensions,
                               double defaultValue) const {
    return has(key) ? dimensioned(key, dimensions) : defaultValue;
}

TokenReader Dictionary::reader(const std::string& key) const {
    DictionaryEntry& entry = demand(key);
    if (entry.dict) fatal(key, "Entry '" + key + "' in dictionary \"" + name() + "\" is a sub-dictionary, not a value");
    entry.readWhole = true;
    return TokenReader(node_, entry.tokens, key, entry.where);
}

void Dictionary::fatal(const std::string& key, const std::string& message) const {
    throw UserError(message, where(key));
}

}  // namespace pfem
