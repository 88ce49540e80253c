#include "dictionary/tokenReader.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "dictionary/dictionary.hpp"

namespace pfem {

namespace {

constexpr std::int64_t maxUniformList = 10'000'000;  // 3{0} repeats: no limit would let a typo take all memory

bool toInteger(const Token& token, std::int64_t& value) {
    if (token.kind != Token::Kind::integer) return false;
    const char* first = token.text.data() + (token.text[0] == '+' ? 1 : 0);
    const char* last = token.text.data() + token.text.size();
    const auto [end, error] = std::from_chars(first, last, value);
    return error == std::errc() && end == last;
}

std::string unescaped(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\')) ++i;
        out += text[i];
    }
    return out;
}

}  // namespace

const Token& TokenReader::peek(std::size_t ahead) const {
    static const Token none;
    return position_ + ahead < tokens_->size() ? (*tokens_)[position_ + ahead] : none;
}

Token TokenReader::next() {
    Token token = peek();
    if (token.isEnd()) {
        token.line = tokens_->empty() ? where_.line : tokens_->back().line;
        token.file = std::make_shared<const std::string>(where_.file);
    } else {
        ++position_;
    }
    return token;
}

void TokenReader::fatal(const std::string& message) const {
    throw UserError("Entry '" + key_ + "': " + message, where_);
}

void TokenReader::wrongType(const std::string& expected, const Token& token) const {
    std::string message = "Wrong token type - expected " + expected + ", found on line " + std::to_string(token.line) +
                          ": " + describe(token) + "\n\nin entry '" + key_ + "'";
    if (token.is('/') || peek().is('/')) message += " (a path must stand in quotes)";
    throw UserError(message, token.file ? token.where() : where_);
}

void TokenReader::expect(char punctuation) {
    const Token token = next();
    if (!token.is(punctuation)) wrongType(std::string("'") + punctuation + "'", token);
}

void TokenReader::end() const {
    if (atEnd()) return;
    const std::size_t count = tokens_->size() - position_;
    std::string message = "Entry '" + key_ + "' has " + std::to_string(count) + " excess tokens in stream\n\n    " +
                          std::to_string(tokens_->size()) + "(";
    message +=
        spelling(Tokens(tokens_->begin(), tokens_->begin() + std::min<std::ptrdiff_t>(10, std::ssize(*tokens_))));
    message += tokens_->size() > 10 ? " ...)" : ")";
    if (peek().firstOnLine && position_ > 0) {
        const Token& last = (*tokens_)[position_ - 1];
        throw UserError(message + "\n\nmissing ';' at the end of line " + std::to_string(last.line) + " ?",
                        last.where());
    }
    throw UserError(message + "\n\nmissing ';' ?", where_);
}

void TokenReader::list(const std::function<void()>& element) {
    if (peek().isWord() && peek().text.starts_with("List<")) next();
    std::int64_t count = -1;
    const Token first = peek();
    const bool counted = first.kind == Token::Kind::integer && (peek(1).is('(') || peek(1).is('{'));
    if (counted) {
        next();
        if (!toInteger(first, count) || count < 0) wrongType("number of list elements", first);
    }
    if (counted && peek().is('{')) {
        next();
        if (count > maxUniformList) fatal("list of " + first.text + " elements is too long");
        const std::size_t start = position_;
        for (std::int64_t i = 0; i < count; ++i) {
            position_ = start;
            element();
        }
        if (count == 0) {
            while (!atEnd() && !peek().is('}')) next();
        }
        expect('}');
        return;
    }
    if (!peek().is('(')) wrongType("list '(...)'", next());
    next();
    std::int64_t n = 0;
    for (; !peek().is(')'); ++n) {
        if (atEnd()) wrongType("')'", next());
        element();
    }
    next();
    if (counted && n != count) fatal("list of " + std::to_string(n) + " elements is announced as one of " + first.text);
}

void TokenReader::readInto(bool& value) {
    const Token token = next();
    const std::string& t = token.text;
    if (token.isWord() && (t == "yes" || t == "on" || t == "true" || t == "y" || t == "t")) {
        value = true;
    } else if (token.isWord() && (t == "no" || t == "off" || t == "false" || t == "n" || t == "f" || t == "none")) {
        value = false;
    } else if (token.kind == Token::Kind::integer && (t == "0" || t == "1")) {
        value = t == "1";
    } else {
        wrongType("bool (yes/no on/off true/false)", token);
    }
}

void TokenReader::readInto(std::int64_t& value) {
    const Token token = next();
    if (!toInteger(token, value)) wrongType("integer value", token);
}

void TokenReader::readInto(int& value) {
    const Token token = next();
    std::int64_t wide = 0;
    if (!toInteger(token, wide) || wide > std::numeric_limits<int>::max() || wide < std::numeric_limits<int>::min()) {
        wrongType("integer value", token);
    }
    value = static_cast<int>(wide);
}

void TokenReader::readInto(double& value) {
    const Token token = next();
    if (!token.isNumber()) wrongType("scalar value", token);
    value = token.number;
}

void TokenReader::readInto(std::string& value) {
    const Token token = next();
    if (!token.isWord() && !token.isString() && token.kind != Token::Kind::verbatim) {
        wrongType("word or string", token);
    }
    if (token.isString()) {
        value = unescaped(token.expanded.empty() ? token.text : token.expanded);
    } else {
        value = token.text;
    }
}

void TokenReader::readInto(Eigen::Vector3d& value) {
    const Token first = peek();
    open();
    for (int i = 0; i < 3; ++i) {
        if (closes()) wrongType("vector of 3 components (x y z)", first);
        readInto(value[i]);
    }
    if (!closes()) wrongType("vector of 3 components (x y z)", first);
    close();
}

void TokenReader::readInto(Dictionary& value) {
    const Token token = next();
    if (token.kind != Token::Kind::dictionary) wrongType("dictionary {...}", token);
    value = *token.dict;
}

}  // namespace pfem
