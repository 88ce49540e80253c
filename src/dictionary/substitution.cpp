// $macros among tokens: `$dict;` as an entry, `$name` in values, `$name` as a keyword.

#include <cstdlib>

#include "dictionary/macros.hpp"
#include "dictionary/parser.hpp"

namespace pfem {

namespace {

[[noreturn]] void unknownMacro(const NodePtr& scope, const Token& variable) {
    std::vector<std::string> known;
    for (NodePtr node = scope; node; node = node->parent.lock()) {
        for (const auto& entry : node->entries) {
            if (entry.key != headerKey) known.push_back(entry.key);
        }
    }
    std::string message = "Illegal dictionary entry or environment variable name \"" + variable.text + '"';
    const std::string near = nearestWord(variable.text, known);
    if (!near.empty()) message += " (did you mean '" + near + "'?)";
    message += "\nKnown dictionary entries: " + std::to_string(known.size()) + '(';
    for (std::size_t i = 0; i < known.size() && i < 50; ++i) message += (i > 0 ? " " : "") + known[i];
    throw UserError(message + (known.size() > 50 ? " ...)" : ")"), variable.where());
}

/// Environment variables and defaults are text, to be split into tokens.
void appendText(const std::string& text, const Token& variable, Tokens& out) {
    Lexer lexer(text, variable.file, variable.line);
    for (Token token = lexer.next(); !token.isEnd(); token = lexer.next()) {
        token.line = variable.line;
        token.firstOnLine = false;
        out.push_back(std::move(token));
    }
}

}  // namespace

void Parser::appendVariable(const NodePtr& scope, const Token& variable, Tokens& out) {
    const MacroDefault parts = splitDefault(expandString(variable.text, *scope, variable.where()));
    const DictionaryEntry* found = findMacro(*scope, parts.name);
    const bool negative = !out.empty() && out.back().is('-') && !variable.spaceBefore;
    const std::size_t first = out.size();
    if (found && parts.operation == '+') {
        appendText(parts.text, variable, out);
    } else if (found && found->dict) {
        Token token = variable;
        token.kind = Token::Kind::dictionary;
        const std::string keyword = !out.empty() && out.back().isWord() ? out.back().text : "";
        token.dict =
            std::make_shared<Dictionary>(copyNode(*found->dict->node(), scope, keyword, variable.where(), budget_));
        out.push_back(std::move(token));
    } else if (found) {
        spend(1 + found->tokens.size(), variable.where());
        for (Token token : found->tokens) {
            token.file = variable.file;  // errors are to name the place of use
            token.line = variable.line;
            token.firstOnLine = false;
            if (token.dict) {
                const auto& inner = *token.dict->node();
                token.dict =
                    std::make_shared<Dictionary>(copyNode(inner, scope, inner.keyword, variable.where(), budget_));
            }
            out.push_back(std::move(token));
        }
    } else if (const char* text = std::getenv(parts.name.c_str())) {
        appendText(parts.operation == '+' ? parts.text : text, variable, out);
    } else if (parts.operation == '-') {
        appendText(expandString(parts.text, *scope, variable.where()), variable, out);
    } else if (parts.operation != '+') {
        unknownMacro(scope, variable);
    }
    if (negative && out.size() == first + 1 && out.back().isNumber()) {  // -$a
        Token token = out.back();
        const std::string text = token.text[0] == '-' ? token.text.substr(1) : '-' + token.text;
        const Token negated = numberOrWord(text);
        token.text = negated.text;
        token.number = negated.number;
        out.pop_back();
        out.back() = std::move(token);
    }
}

std::string Parser::variableAsWord(const NodePtr& scope, const Token& variable) {
    Tokens tokens;
    appendVariable(scope, variable, tokens);
    if (tokens.size() != 1 || tokens[0].kind == Token::Kind::dictionary) {
        throw UserError("$" + variable.text + " does not stand for one word", variable.where());
    }
    return tokens[0].expanded.empty() ? tokens[0].text : tokens[0].expanded;
}

/// `$dict;` copies all entries of a dictionary, also without ';'. `$name value;` takes its keyword from
/// `name`.
void Parser::substitute(Lexer& lexer, const NodePtr& node, const Token& variable) {
    const DictionaryEntry* found = findMacro(*node, expandString(variable.text, *node, variable.where()), true);
    if (found && found->dict) {
        const NodePtr copy = copyNode(*found->dict->node(), node, node->keyword, variable.where(), budget_);
        for (auto& copied : copy->entries) {
            if (copied.dict) copied.dict->node()->parent = node;
            add(node, std::move(copied));
        }
        return;
    }
    const Token next = lexer.next();
    lexer.putBack(next);
    if (next.is(';') || next.is('}') || next.isEnd()) {
        if (!found) unknownMacro(node, variable);
        throw UserError("$" + variable.text + " is not a dictionary: its entries cannot be copied here",
                        variable.where());
    }
    Token key = variable;
    key.text = variableAsWord(node, variable);
    key.kind = Token::Kind::word;
    entry(lexer, node, key);
}

}  // namespace pfem
