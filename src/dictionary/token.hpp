#pragma once
// The smallest pieces of a dictionary file, each with the place where it stands.

#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace pfem {

class Dictionary;

struct Token {
    enum class Kind { end, punctuation, word, string, verbatim, integer, scalar, variable, directive, dictionary };

    Kind kind = Kind::end;
    std::string text;      ///< as written, without quotes, '$', '#' or "#{ #}"
    std::string expanded;  ///< of a string: with its $macros replaced; empty if there are none
    double number = 0;     ///< of an integer or a scalar
    std::shared_ptr<const std::string> file;
    int line = 0;
    bool firstOnLine = false;          ///< helps to find forgotten semicolons
    bool spaceBefore = false;          ///< tells 3{0} (a uniform list) from 3 {...}
    std::shared_ptr<Dictionary> dict;  ///< of a dictionary within a list

    bool is(char c) const { return kind == Kind::punctuation && text.size() == 1 && text[0] == c; }
    bool isWord() const { return kind == Kind::word; }
    bool isString() const { return kind == Kind::string; }
    bool isNumber() const { return kind == Kind::integer || kind == Kind::scalar; }
    bool isEnd() const { return kind == Kind::end; }

    Location where() const { return {file ? *file : std::string(), line}; }
};

using Tokens = std::vector<Token>;

/// "word 'abc'", "number 5", "punctuation '('": for messages.
std::string describe(const Token& token);

/// As it would be written in a file: strings with quotes, verbatim text with #{ #}.
std::string spelling(const Token& token);

/// Words separated by one space.
std::string spelling(const Tokens& tokens);

/// Number or word? Rejects what no double can hold; "1e", "1.2.3" and "1.0abc" are words.
Token numberOrWord(std::string text);

}  // namespace pfem
