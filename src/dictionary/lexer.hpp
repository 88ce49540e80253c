#pragma once
// Splits text into tokens; skips white space and comments.

#include <optional>
#include <string>

#include "dictionary/token.hpp"

namespace pfem {

class Lexer {
public:
    /// `firstLine`: the number of the text's first line, for pieces cut out of a larger file.
    Lexer(std::string text, std::shared_ptr<const std::string> file, int firstLine = 1);

    Token next();
    void putBack(Token token) { putBack_ = std::move(token); }

    /// The text up to the matching '}' ; the '{' has been read. For #eval{ ... }.
    std::string untilClosingBrace();
    /// A string, or what is left of this line: the argument of #include and #includeFunc.
    std::string lineArgument();
    /// What is left of this line without comments and white space around it. For #include etc.
    std::string restOfLine();

    Location where() const { return {*file_, line_}; }
    const std::shared_ptr<const std::string>& file() const { return file_; }

private:
    bool atEnd() const { return position_ >= text_.size(); }
    char peek(std::size_t ahead = 0) const;
    char get();
    void skipSpaceAndComments();
    Token string();
    Token verbatim();
    Token variable();
    std::string word();
    [[noreturn]] void fail(const std::string& message, int line) const;

    std::string text_;
    std::shared_ptr<const std::string> file_;
    std::size_t position_ = 0;
    int line_ = 1;
    int lineOfLastToken_ = 0;
    bool inBrackets_ = false;  ///< of dimensions, where '(' groups: [kg*(m s)^-1]
    std::optional<Token> putBack_;
};

}  // namespace pfem
