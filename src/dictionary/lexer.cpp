#include "dictionary/lexer.hpp"

#include <cstring>

#include "dictionary/files.hpp"

namespace pfem {

namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

/// Characters of a word; parentheses and brackets only balanced.
bool isWordCharacter(char c) { return c != '\0' && !isSpace(c) && !std::strchr("\"'/;{}", c); }

}  // namespace

Lexer::Lexer(std::string text, std::shared_ptr<const std::string> file, int firstLine)
    : text_(std::move(text)), file_(std::move(file)), line_(firstLine) {
    position_ = byteOrderMark(text_);
    const auto nul = text_.find('\0');
    if (nul != std::string::npos) {
        for (std::size_t i = 0; i < nul; ++i) line_ += text_[i] == '\n';
        fail("This is not a text file: it contains a zero byte", line_);
    }
}

void Lexer::fail(const std::string& message, int line) const { throw UserError(message, {*file_, line}); }

char Lexer::peek(std::size_t ahead) const { return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0'; }

char Lexer::get() {
    const char c = text_[position_++];
    if (c == '\n') ++line_;
    return c;
}

void Lexer::skipSpaceAndComments() {
    while (!atEnd()) {
        if (isSpace(peek())) {
            get();
        } else if (peek() == '/' && peek(1) == '/') {
            while (!atEnd() && peek() != '\n') get();
        } else if (peek() == '/' && peek(1) == '*') {
            const int start = line_;
            const auto close = text_.find("*/", position_ + 2);
            if (close == std::string::npos) fail("Comment /* without its end */", start);
            while (position_ < close + 2) get();
        } else {
            return;
        }
    }
}

Token Lexer::next() {
    if (putBack_) {
        Token token = std::move(*putBack_);
        putBack_.reset();
        return token;
    }
    const std::size_t before = position_;
    skipSpaceAndComments();
    const bool space = position_ != before;
    const int start = line_;

    Token token;
    if (!atEnd()) {
        const char c = peek();
        const char second = peek(1);
        const bool digit = c >= '0' && c <= '9';
        if (c == '"') {
            token = string();
        } else if (c == '#' && second == '{') {
            token = verbatim();
        } else if (c == '#' && isWordCharacter(second)) {
            get();
            token.kind = Token::Kind::directive;
            token.text = word();
        } else if (c == '$' && (second == '{' || second == '/' || isWordCharacter(second))) {
            token = variable();
        } else if (std::strchr(";(){}[],:=*/'", c) || ((c == '-' || c == '+') && !isWordCharacter(second)) ||
                   (c == '-' && second == '$')) {
            token.kind = Token::Kind::punctuation;
            token.text = get();
            if (c == '[') inBrackets_ = true;
            if (c == ']' || c == ';') inBrackets_ = false;
        } else if (digit || c == '-' || c == '+' || c == '.') {
            token = numberOrWord(word());
        } else {
            token.kind = Token::Kind::word;
            token.text = word();
        }
    }
    token.file = file_;
    token.line = start;
    token.firstOnLine = start != lineOfLastToken_;
    token.spaceBefore = space;
    lineOfLastToken_ = start;
    return token;
}

std::string Lexer::word() {
    const int start = line_;
    std::string text;
    int parentheses = 0;
    int brackets = 0;
    while (!atEnd() && isWordCharacter(peek())) {
        const char c = peek();
        if (inBrackets_ && (c == '(' || c == '*')) break;
        if (c == '(') {
            // 3(1 2 3) is a counted list
            if (parentheses == 0 && numberOrWord(text).kind == Token::Kind::integer) break;
            ++parentheses;
        }
        if (c == ')' && parentheses-- == 0) break;
        if (c == '[') ++brackets;
        if (c == ']' && brackets-- == 0) break;
        if (c == ',' && parentheses <= 0 && numberOrWord(text).isNumber()) break;
        text += get();
    }
    if (parentheses > 0) fail("Word '" + text + "' has '(' without ')'; a list needs a space before '('", start);
    return text;
}

Token Lexer::string() {
    Token token;
    token.kind = Token::Kind::string;
    const int start = line_;
    get();
    while (true) {
        if (atEnd()) fail("String \"" + token.text.substr(0, 40) + " without its closing quote", start);
        const char c = get();
        if (c == '"') return token;
        if (c == '\n') {
            fail("found '\\n' while reading string \"" + token.text + "\": closing quote forgotten ?", start);
        }
        token.text += c;
        if (c == '\\' && !atEnd()) token.text += get();
    }
}

Token Lexer::verbatim() {
    Token token;
    token.kind = Token::Kind::verbatim;
    const int start = line_;
    const auto close = text_.find("#}", position_ + 2);
    if (close == std::string::npos) fail("Verbatim text #{ without its end #}", start);
    token.text = text_.substr(position_ + 2, close - position_ - 2);
    while (position_ < close + 2) get();
    return token;
}

Token Lexer::variable() {
    Token token;
    token.kind = Token::Kind::variable;
    const int start = line_;
    get();
    if (peek() == '{') {  // ${name}, ${name:-default}, ${a${b}}
        get();
        token.text = untilClosingBrace();
        return token;
    }
    // Paths with slashes only where they cannot be meant otherwise: $../x, $!a/b and $/a/b
    const bool path = text_.compare(position_, 3, "../") == 0 || peek() == '!' || peek() == '/';
    int parentheses = 0;
    while (!atEnd() && (isWordCharacter(peek()) || (path && peek() == '/')) && peek() != '[') {
        const char c = peek();
        if (c == '(') ++parentheses;
        if (c == ')' && parentheses-- == 0) break;
        if (c == ']' || (c == ',' && parentheses <= 0)) break;
        token.text += get();
    }
    if (parentheses > 0) fail("Variable $" + token.text + " has '(' without ')'", start);
    if (token.text.empty()) fail("'$' without a name", start);
    return token;
}

std::string Lexer::untilClosingBrace() {
    const int start = line_;
    std::string text;
    for (int depth = 1; !atEnd();) {
        const char c = get();
        if (c == '{') ++depth;
        if (c == '}' && --depth == 0) return text;
        text += c;
    }
    fail("'{' without its closing '}'", start);
}

std::string Lexer::lineArgument() {
    while (peek() == ' ' || peek() == '\t') get();
    if (peek() == '"') return string().text;
    std::string text = restOfLine();
    while (text.ends_with(';') || text.ends_with(' ')) text.pop_back();
    return text;
}

std::string Lexer::restOfLine() {
    std::string text;
    while (!atEnd() && peek() != '\n' && !(peek() == '/' && (peek(1) == '/' || peek(1) == '*'))) text += get();
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace pfem
