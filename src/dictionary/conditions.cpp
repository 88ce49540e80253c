// #if #ifeq #else #endif

#include "dictionary/expression.hpp"
#include "dictionary/macros.hpp"
#include "dictionary/parser.hpp"

namespace pfem {

bool Parser::condition(Lexer& lexer, const NodePtr& scope, const Token& token) {
    const std::string line = lexer.restOfLine();
    Lexer words(line, token.file, token.line);
    Tokens tokens;
    value(words, scope, token, tokens, true);

    if (token.text == "ifeq") {
        if (tokens.size() != 2) throw UserError("#ifeq needs two words, found '" + line + "'", token.where());
        if (tokens[0].isNumber() && tokens[1].isNumber()) return tokens[0].number == tokens[1].number;
        return tokens[0].text == tokens[1].text;
    }
    if (tokens.empty()) throw UserError("#if without a condition", token.where());
    if (tokens.size() == 1 && (tokens[0].isWord() || tokens[0].isNumber())) {
        if (tokens[0].isNumber()) return tokens[0].number != 0;
        return TokenReader(nullptr, tokens, "#if", token.where()).read<bool>();
    }
    std::string text = tokens.size() == 1 ? tokens[0].text : expandString(line, *scope, token.where(), true);
    if (tokens.size() == 1 && tokens[0].isString()) text = expandString(tokens[0].text, *scope, token.where(), true);
    return evaluateScalar(text, token.where()) != 0;
}

bool Parser::skipBranch(Lexer& lexer, const Token& start, bool elseCounts) {
    int depth = 0;
    while (true) {
        const Token token = lexer.next();
        if (token.isEnd()) throw UserError("#" + start.text + " without #endif", start.where());
        if (token.kind != Token::Kind::directive) continue;
        if (token.text == "if" || token.text == "ifeq") ++depth;
        if (token.text == "else" && depth == 0 && elseCounts) return true;
        if (token.text == "endif" && depth-- == 0) return false;
    }
}

}  // namespace pfem
