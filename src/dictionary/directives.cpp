// #include and its relatives, #remove, #inputMode, #eval.

#include <algorithm>

#include "dictionary/expression.hpp"
#include "dictionary/files.hpp"
#include "dictionary/macros.hpp"
#include "dictionary/parser.hpp"

namespace fs = std::filesystem;

namespace pfem {

namespace {

const std::vector<std::string> directives = {"include",     "includeIfPresent",
                                             "sinclude",    "includeEtc",
                                             "sincludeEtc", "includeFunc",
                                             "inputMode",   "remove",
                                             "eval",        "calc",
                                             "if",          "ifeq",
                                             "else",        "endif"};

bool silent(const std::string& name) { return name == "includeIfPresent" || name.starts_with("sinclude"); }
bool isInclude(const std::string& name) { return name == "include" || name == "includeEtc" || silent(name); }

[[noreturn]] void unknown(const Token& token) {
    if (token.text == "codeStream") {
        throw UserError("#codeStream is not supported: dictionaries are never compiled. Use #eval", token.where());
    }
    throw UserError(notValid("#" + token.text, "directive", directives), token.where());
}

}  // namespace

void Parser::directive(Lexer& lexer, const NodePtr& node, const Token& token) {
    if (token.text == "includeFunc") {
        includeFunction(lexer, node, token);
    } else if (isInclude(token.text)) {
        include(lexer, node, token);
    } else if (token.text == "remove") {
        removeKeys(lexer, node, token);
    } else if (token.text == "inputMode") {
        setInputMode(lexer, token);
    } else if (token.text == "eval" || token.text == "calc") {
        throw UserError("#" + token.text + " needs a keyword before it", token.where());
    } else {
        unknown(token);
    }
}

void Parser::valueDirective(Lexer& lexer, const NodePtr& scope, const Token& token, const Token& key, Tokens& out) {
    if (token.text == "eval" || token.text == "calc") {
        evaluate(lexer, scope, token, out);
    } else if (isInclude(token.text)) {
        const fs::path file = includedFile(lexer, scope, token);
        if (file.empty()) return;
        Lexer inner = openFile(file, token);
        value(inner, scope, key, out, true);
        open_.pop_back();
    } else {
        unknown(token);
    }
}

void Parser::evaluate(Lexer& lexer, const NodePtr& scope, const Token& token, Tokens& out) {
    const Token argument = lexer.next();
    std::string text = argument.text;
    if (argument.is('{')) {
        text = lexer.untilClosingBrace();
    } else if (!argument.isString() && argument.kind != Token::Kind::verbatim) {
        throw UserError("#" + token.text + " needs \"expression\" or { expression }", token.where());
    }
    const std::string result = evaluateToText(expandString(text, *scope, token.where(), true), token.where());
    Lexer tokens(result, token.file, token.line);
    for (Token t = tokens.next(); !t.isEnd(); t = tokens.next()) {
        t.firstOnLine = false;
        out.push_back(std::move(t));
    }
}

/// The file a directive names; empty if it is absent and need not be there.
fs::path Parser::includedFile(Lexer& lexer, const NodePtr& scope, const Token& token) {
    const std::string text = lexer.lineArgument();
    if (text.empty()) throw UserError("#" + token.text + " needs a file name", token.where());
    const std::string name = expandString(text, *scope, token.where());

    fs::path file = expandTags(name, open_.empty() ? fs::path(*token.file) : open_.front());
    std::error_code error;
    if (token.text.ends_with("Etc")) {
        const auto found = findEtc(file);
        if (!found && !silent(token.text)) {
            throw UserError("cannot find file \"" + name + "\" in $PFEM_ETC, ~/.pfem or the installation's etc",
                            token.where());
        }
        file = found.value_or(fs::path());
    } else {
        if (file.is_relative()) file = (fs::path(*token.file).parent_path() / file).lexically_normal();
        if (silent(token.text) && !fs::exists(file, error)) file.clear();
    }
    return file;
}

/// The text of a file, or what stands for it.
std::string Parser::textOf(const fs::path& file, const Location& where) const {
    const auto changed = changed_.empty() ? changed_.end() : changed_.find(fs::weakly_canonical(file));
    return changed == changed_.end() ? fileText(file, where) : changed->second;
}

/// The text of a file, noted as open: cycles end here. The caller closes it with open_.pop_back().
Lexer Parser::openFile(const fs::path& file, const Token& token) {
    std::error_code error;
    const fs::path same = fs::weakly_canonical(file, error);
    if (std::find(open_.begin(), open_.end(), same) != open_.end()) {
        throw UserError("File \"" + file.string() + "\" includes itself", token.where());
    }
    if (open_.size() > 50) throw UserError("Files include each other too deeply", token.where());
    open_.push_back(same);
    return Lexer(textOf(file, token.where()), std::make_shared<const std::string>(file.string()));
}

void Parser::includeFile(const fs::path& file, const NodePtr& node, const Token& token) {
    Lexer inner = openFile(file, token);
    entries(inner, node, {});
    open_.pop_back();
}

void Parser::include(Lexer& lexer, const NodePtr& node, const Token& token) {
    const fs::path file = includedFile(lexer, node, token);
    if (!file.empty()) includeFile(file, node, token);
}

/// #remove key   #remove (a "b.*")
void Parser::removeKeys(Lexer& lexer, const NodePtr& node, const Token& token) {
    Tokens words;
    Token first = lexer.next();
    if (first.is('(')) {
        for (Token word = lexer.next(); !word.is(')'); word = lexer.next()) {
            if (word.isEnd() || word.is(';')) throw UserError("#remove ( without )", token.where());
            words.push_back(std::move(word));
        }
    } else {
        words.push_back(std::move(first));
    }
    for (const auto& word : words) {
        if (word.isString() && KeyPattern::isPattern(word.text)) {
            const KeyPattern pattern(word.text, word.where());
            std::vector<std::string> matching;
            for (const auto& entry : node->entries) {
                if (pattern.matches(entry.key)) matching.push_back(entry.key);
            }
            for (const auto& key : matching) node->remove(key);
        } else if (word.isWord() || word.isString() || word.isNumber()) {
            node->remove(word.text);
        } else {
            throw UserError("#remove needs a keyword, found " + describe(word), token.where());
        }
    }
}

void Parser::setInputMode(Lexer& lexer, const Token& token) {
    static const std::vector<std::string> names = {"merge", "overwrite", "protect", "warn", "error", "default"};
    const std::string name = lexer.next().text;
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) throw UserError(notValid(name, "inputMode", names), token.where());
    mode_ = name == "default" ? InputMode::merge : static_cast<InputMode>(place - names.begin());
}

}  // namespace pfem
