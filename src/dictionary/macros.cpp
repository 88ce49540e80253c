#include "dictionary/macros.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace pfem {

namespace {

constexpr std::size_t maxExpansion = 100'000;

/// "a.b.c" in this dictionary only. Keys may contain dots themselves (alpha.water): the whole name first,
/// then every way to cut it. What is found, and the dictionaries on the way, count as used.
const DictionaryEntry* findScoped(DictionaryNode& node, const std::string& name, bool patterns, int depth = 0) {
    if (auto* entry = node.find(name, patterns)) {
        entry->inMacro = true;
        return entry;
    }
    if (depth > 20) return nullptr;
    for (auto dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1)) {
        if (dot == 0) continue;
        auto* outer = node.find(name.substr(0, dot), patterns);
        if (!outer || !outer->dict) continue;
        const auto* inner = findScoped(*outer->dict->node(), name.substr(dot + 1), patterns, depth + 1);
        if (inner == nullptr) continue;
        outer->inMacro = true;
        return inner;
    }
    return nullptr;
}

DictionaryNode* top(DictionaryNode* node) {
    while (auto parent = node->parent.lock()) node = parent.get();
    return node;
}

}  // namespace

const DictionaryEntry* findMacro(const DictionaryNode& scope, const std::string& macro, bool patterns) {
    auto* node = const_cast<DictionaryNode*>(&scope);  // find() is shared with the reading side
    std::string name = macro;
    bool outwards = true;
    if (name.starts_with(':') || name.starts_with('^') || name.starts_with('!') || name.starts_with('/')) {
        node = top(node);
        outwards = false;
        if (name[0] == '!' || name[0] == '/') std::replace(name.begin(), name.end(), '/', '.');
        name.erase(0, 1);
    } else if (name.starts_with("../")) {
        outwards = false;
        while (name.starts_with("../")) {
            auto parent = node->parent.lock();
            if (!parent) return nullptr;
            node = parent.get();
            name.erase(0, 3);
        }
        std::replace(name.begin(), name.end(), '/', '.');
    } else if (name.starts_with('.')) {
        outwards = false;
        name.erase(0, 1);
        while (name.starts_with('.')) {
            auto parent = node->parent.lock();
            if (!parent) return nullptr;
            node = parent.get();
            name.erase(0, 1);
        }
    }
    if (name.empty()) return nullptr;
    while (true) {
        if (const auto* entry = findScoped(*node, name, patterns)) return entry;
        auto parent = node->parent.lock();
        if (!outwards || !parent) return nullptr;
        node = parent.get();
    }
}

MacroDefault splitDefault(const std::string& name) {
    MacroDefault result;
    const auto colon = std::min(name.find(":-"), name.find(":+"));
    result.name = name.substr(0, colon);
    if (colon != std::string::npos) {
        result.operation = name[colon + 1];
        result.text = name.substr(colon + 2);
    }
    return result;
}

namespace {

bool isNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == ':' || c == '^';
}

/// As part of a formula: negative numbers in parentheses, vectors as vector(x,y,z).
std::string operand(const Tokens& tokens) {
    if (tokens.size() == 1 && tokens[0].isNumber() && tokens[0].number < 0) return '(' + tokens[0].text + ')';
    const bool vector = tokens.size() == 5 && tokens[0].is('(') && tokens[1].isNumber() && tokens[2].isNumber() &&
                        tokens[3].isNumber() && tokens[4].is(')');
    if (!vector) return spelling(tokens);
    return "vector(" + tokens[1].text + ',' + tokens[2].text + ',' + tokens[3].text + ')';
}

/// The value as text, or nothing.
std::optional<std::string> lookUp(const std::string& macro, const DictionaryNode& scope, const Location& where,
                                  bool inExpression, int depth) {
    const MacroDefault parts = splitDefault(macro);
    std::optional<std::string> found;
    if (const auto* entry = findMacro(scope, parts.name); entry && !entry->dict) {
        const Tokens& tokens = entry->tokens;
        if (tokens.size() == 1 && tokens[0].isString()) {
            found = tokens[0].expanded.empty() ? tokens[0].text : tokens[0].expanded;
        } else {
            found = inExpression ? operand(tokens) : spelling(tokens);
        }
    } else if (const char* text = std::getenv(parts.name.c_str())) {
        found = text;
    }
    if (parts.operation == '+')
        return found && !found->empty() ? expandString(parts.text, scope, where, inExpression, depth + 1) : "";
    if (parts.operation == '-' && (!found || found->empty()))
        return expandString(parts.text, scope, where, inExpression, depth + 1);
    return found;
}

}  // namespace

std::string expandString(const std::string& text, const DictionaryNode& scope, const Location& where, bool inExpression,
                         int depth) {
    if (depth > 20 || text.find('$') == std::string::npos) return text;
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '$') {
            out += '$';
            i += 2;
            continue;
        }
        if (text[i] != '$' || i + 1 >= text.size()) {
            out += text[i++];
            continue;
        }
        std::size_t end = i + 1;
        std::string name;
        if (text[end] == '{') {
            int braces = 1;
            for (++end; end < text.size() && braces > 0; ++end) {
                braces += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
            }
            if (braces == 0) name = expandString(text.substr(i + 2, end - i - 3), scope, where, false, depth + 1);
        } else {
            while (end < text.size() && isNameCharacter(text[end])) ++end;
            name = text.substr(i + 1, end - i - 1);
            // A dot or colon at the end belongs to the text: "$FOAM_CASE." ; so does what follows a known
            // name
            while (!name.empty() && !std::isalnum(static_cast<unsigned char>(name.back())) && name.back() != '_') {
                name.pop_back();
                --end;
            }
        }
        std::optional<std::string> value;
        if (!name.empty()) value = lookUp(name, scope, where, inExpression, depth);
        // "$name.txt" means name where there is no entry "name.txt"
        while (!value && text[i + 1] != '{' && name.find('.', 1) != std::string::npos) {
            const auto dot = name.rfind('.');
            end -= name.size() - dot;
            name.erase(dot);
            value = lookUp(name, scope, where, inExpression, depth);
        }
        out += value ? *value : text.substr(i, end - i);
        if (out.size() > maxExpansion) throw UserError("The macros of a string expand to too much text", where);
        i = end;
    }
    return out;
}

}  // namespace pfem
