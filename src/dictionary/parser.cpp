#include "dictionary/parser.hpp"

#include <algorithm>
#include <iostream>

#include "dictionary/files.hpp"
#include "dictionary/macros.hpp"

namespace pfem {

void Parser::readFile(const std::filesystem::path& file, const NodePtr& into) {
    Lexer lexer(textOf(file, {}), std::make_shared<const std::string>(file.string()));
    open_.push_back(std::filesystem::weakly_canonical(file));
    entries(lexer, into, {});
    open_.pop_back();
    into->where.lastLine = lexer.where().line;
}

void Parser::readText(const std::string& text, const std::string& name, const NodePtr& into) {
    Lexer lexer(text, std::make_shared<const std::string>(name));
    entries(lexer, into, {});
    into->where.lastLine = lexer.where().line;
}

void Parser::spend(std::size_t tokens, const Location& where) {
    budget_ -= static_cast<long>(tokens);
    if (budget_ < 0) throw UserError("The macros of this file expand to too much text", where);
}

/// Up to the closing brace of `openBrace`, or to the end of the file if that is no brace.
void Parser::entries(Lexer& lexer, const NodePtr& node, const Token& openBrace) {
    Tokens conditions;  // the open #if's
    while (true) {
        Token token = lexer.next();
        if (token.isEnd()) {
            if (!conditions.empty())
                throw UserError("#" + conditions.back().text + " without #endif", conditions.back().where());
            if (openBrace.isEnd()) return;
            throw UserError(
                "Unexpected EOF while reading dictionary entry: '{' of '" + node->keyword + "' without its closing '}'",
                openBrace.where());
        }
        if (token.is('}')) {
            if (!conditions.empty())
                throw UserError("#" + conditions.back().text + " without #endif", conditions.back().where());
            if (!openBrace.isEnd()) return;
            throw UserError("Unexpected '}' while reading dictionary entry: more '}' than '{'", token.where());
        }
        if (token.is(';')) continue;
        if (token.kind == Token::Kind::directive) {
            const std::string& name = token.text;
            if (name == "if" || name == "ifeq") {
                if (condition(lexer, node, token) || skipBranch(lexer, token, true)) conditions.push_back(token);
            } else if (name == "else" || name == "endif") {
                if (conditions.empty()) throw UserError("#" + name + " without #if", token.where());
                if (name == "else") skipBranch(lexer, conditions.back(), false);
                conditions.pop_back();
            } else {
                directive(lexer, node, token);
            }
        } else if (token.kind == Token::Kind::variable) {
            substitute(lexer, node, token);
        } else {
            entry(lexer, node, token);
        }
    }
}

void Parser::entry(Lexer& lexer, const NodePtr& node, const Token& key) {
    if (!key.isWord() && !key.isString() && !key.isNumber()) {
        throw UserError("A keyword is expected, found " + describe(key), key.where());
    }
    DictionaryEntry result;
    result.key = key.text;
    result.quoted = key.isString();
    result.where = key.where();
    if (key.isString() && KeyPattern::isPattern(key.text)) result.pattern.emplace(key.text, key.where());

    const Token next = lexer.next();
    if (next.is('{')) {
        result.dict = std::make_shared<Dictionary>(dictionary(lexer, node, key.text, next));
    } else {
        lexer.putBack(next);
        value(lexer, node, key, result.tokens);
        // `a $b;` with a dictionary b makes a the copy of it
        if (result.tokens.size() == 1 && result.tokens[0].kind == Token::Kind::dictionary) {
            const auto& source = *result.tokens[0].dict->node();
            result.dict = std::make_shared<Dictionary>(copyNode(source, node, key.text, key.where(), budget_));
            result.tokens.clear();
        }
    }
    const bool headerOfInclude = open_.size() > 1 && result.dict && result.key == headerKey;
    if (!headerOfInclude) add(node, std::move(result));
}

NodePtr Parser::dictionary(Lexer& lexer, const NodePtr& parent, const std::string& keyword, const Token& openBrace) {
    if (depthOf(parent) >= maxDepth) throw UserError("Dictionaries are nested too deeply", openBrace.where());
    auto node = makeNode(parent, keyword, openBrace.where());
    entries(lexer, node, openBrace);
    node->where.lastLine = lexer.where().line;
    return node;
}

/// The tokens up to ';' (or to the end of an included file).
void Parser::value(Lexer& lexer, const NodePtr& scope, const Token& key, Tokens& out, bool untilEnd) {
    Tokens open;
    const auto notEnded = [&](const std::string& found) {
        // In "a 1 <newline> sub {" it is the line of "a 1", before the name of the dictionary.
        std::size_t last = out.size();
        if (found == "'{'" && last > 1 && out[last - 1].firstOnLine) --last;
        const Location where = last == 0 ? key.where() : out[last - 1].where();
        throw UserError("Entry '" + key.text + "' is not ended before " + found + ": missing ';' ?", where);
    };
    while (true) {
        Token token = lexer.next();
        if (token.isEnd()) {
            if (untilEnd && open.empty()) return;
            if (!open.empty())
                throw UserError(
                    "Imbalanced brackets: '" + open.back().text + "' is not closed in entry '" + key.text + "'",
                    open.back().where());
            notEnded("the end of the file");
        }
        if (token.is(';') && !untilEnd) {
            if (open.empty()) return;
            throw UserError("Imbalanced brackets: '" + open.back().text + "' is not closed in entry '" + key.text + "'",
                            open.back().where());
        }
        if (token.is('{')) {
            const bool uniform = !out.empty() && out.back().kind == Token::Kind::integer && !token.spaceBefore;
            // "Gauss multivariateSelection {...};" is a value; a name alone on its line begins the next
            // entry.
            const bool nextEntry = out.empty() || (out.size() > 1 && out.back().firstOnLine) || !out.back().isWord();
            if (!uniform && open.empty() && nextEntry) notEnded("'{'");
            if (!uniform) {
                const bool named = !out.empty() && (out.back().isWord() || out.back().isString());
                Token dict = token;
                dict.kind = Token::Kind::dictionary;
                dict.dict = std::make_shared<Dictionary>(
                    dictionary(lexer, scope, named ? out.back().text : std::string(), token));
                out.push_back(std::move(dict));
                continue;
            }
        }
        if (token.is('(') || token.is('[') || token.is('{')) open.push_back(token);
        if (token.is(')') || token.is(']') || token.is('}')) {
            const char* const match = token.is(')') ? "(" : token.is(']') ? "[" : "{";
            if (open.empty() && token.is('}')) notEnded("'}'");
            if (open.empty() || open.back().text != match) {
                throw UserError(
                    "Imbalanced brackets: '" + token.text + "' without '" + match + "' in entry '" + key.text + "'",
                    token.where());
            }
            open.pop_back();
        }
        if (token.kind == Token::Kind::variable) {
            appendVariable(scope, token, out);
        } else if (token.kind == Token::Kind::directive) {
            valueDirective(lexer, scope, token, key, out);
        } else {
            if (token.isString() && token.text.find('$') != std::string::npos) {
                token.expanded = expandString(token.text, *scope, token.where());
                spend(token.expanded.size() / 100, token.where());
            }
            out.push_back(std::move(token));
        }
    }
}

void Parser::add(const NodePtr& node, DictionaryEntry entry) {
    const DictionaryEntry* old = node->find(entry.key, false);
    if (old && mode_ == InputMode::error) {
        throw UserError("Entry '" + entry.key + "' is given twice (#inputMode error)", entry.where);
    }
    if (old && mode_ == InputMode::warn) {
        std::cerr << "--> PFEM Warning: entry '" << entry.key << "' in " << entry.where.file << ':' << entry.where.line
                  << " is given twice and ignored (#inputMode warn)\n";
    }
    if (old && (mode_ == InputMode::protect || mode_ == InputMode::warn)) return;
    if (old && old->dict && entry.dict && mode_ == InputMode::merge) {
        mergeInto(old->dict->node(), entry.dict->node());
    } else {
        node->add(std::move(entry));
    }
}

}  // namespace pfem
