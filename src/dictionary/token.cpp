#include "dictionary/token.hpp"

#include <charconv>
#include <system_error>

#include "dictionary/dictionary.hpp"
#include "dictionary/print.hpp"

namespace pfem {

std::string describe(const Token& token) {
    switch (token.kind) {
        case Token::Kind::end:
            return "end of entry";
        case Token::Kind::punctuation:
            return "punctuation '" + token.text + "'";
        case Token::Kind::word:
            return "word '" + token.text + "'";
        case Token::Kind::string:
            return "string \"" + token.text + "\"";
        case Token::Kind::verbatim:
            return "verbatim text";
        case Token::Kind::integer:
        case Token::Kind::scalar:
            return "number " + token.text;
        case Token::Kind::variable:
            return "variable $" + token.text;
        case Token::Kind::directive:
            return "directive #" + token.text;
        case Token::Kind::dictionary:
            return "dictionary {...}";
    }
    return {};
}

std::string spelling(const Token& token) {
    switch (token.kind) {
        case Token::Kind::string:
            return '"' + token.text + '"';
        case Token::Kind::verbatim:
            return "#{" + token.text + "#}";
        case Token::Kind::variable:
            return "$" + token.text;
        case Token::Kind::directive:
            return "#" + token.text;
        case Token::Kind::dictionary:
            return "{ " + oneLine(*token.dict) + "}";
        default:
            return token.text;
    }
}

std::string spelling(const Tokens& tokens) {
    std::string text;
    for (const auto& token : tokens) {
        if (!text.empty() && !token.is('{')) text += ' ';  // 3{0}: without the space it is a uniform list
        text += spelling(token);
    }
    return text;
}

Token numberOrWord(std::string text) {
    Token token;
    token.kind = Token::Kind::word;
    token.text = std::move(text);
    const char* first = token.text.data();
    const char* last = first + token.text.size();
    if (first != last && *first == '+') ++first;  // from_chars knows no plus sign
    const char* digit = first != last && *first == '-' ? first + 1 : first;
    // Only digits may follow: from_chars would also take "inf" and "nan".
    if (digit == last || !((*digit >= '0' && *digit <= '9') || *digit == '.')) return token;

    const auto [end, error] = std::from_chars(first, last, token.number);
    if (end != last || error != std::errc()) {
        token.number = 0;
        return token;
    }
    const bool fractional = token.text.find_first_of(".eE") != std::string::npos;
    token.kind = fractional ? Token::Kind::scalar : Token::Kind::integer;
    return token;
}

}  // namespace pfem
