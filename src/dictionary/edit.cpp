#include "dictionary/edit.hpp"

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "dictionary/dictionary.hpp"
#include "dictionary/files.hpp"

namespace pfem {

namespace {

/// Where an entry stands: positions in the text.
struct Span {
    std::string key;
    std::size_t begin = 0, end = 0;            // from the keyword to behind ';' or '}'
    std::size_t valueBegin = 0, valueEnd = 0;  // without ';'; of a dictionary: between its braces
    bool isDict = false;
};

/// Walks through text without understanding it.
class Scanner {
public:
    Scanner(const std::string& text, std::size_t at, std::size_t end) : text_(text), at_(at), end_(end) {}

    /// The entries from here to the end or an unmatched '}'.
    std::vector<Span> entries() {
        std::vector<Span> all;
        for (skipBlanks(); at_ < end_ && text_[at_] != '}'; skipBlanks()) all.push_back(entry());
        return all;
    }

private:
    bool startsWith(const char* word) const { return text_.compare(at_, std::string(word).size(), word) == 0; }

    void to(const std::string& word, std::size_t from) {
        const auto found = text_.find(word, from);
        at_ = found == std::string::npos || found >= end_ ? end_ : found + word.size();
    }

    /// False at a character that is neither blank nor comment.
    bool skipBlank() {
        if (std::isspace(static_cast<unsigned char>(text_[at_])))
            ++at_;
        else if (startsWith("//"))
            to("\n", at_);
        else if (startsWith("/*"))
            to("*/", at_ + 2);
        else
            return false;
        return true;
    }
    void skipBlanks() {
        while (at_ < end_ && skipBlank()) {
        }
    }

    void skipString() {
        for (++at_; at_ < end_ && text_[at_] != '"'; ++at_)
            if (text_[at_] == '\\') ++at_;
        at_ = std::min(at_ + 1, end_);
    }

    /// One character, or a whole string, verbatim text or bracket.
    void skipItem() {
        const char c = text_[at_];
        if (c == '"')
            skipString();
        else if (startsWith("#{"))
            to("#}", at_);
        else if (c == '(' || c == '{' || c == '[')
            skipBracket();
        else
            ++at_;
    }
    void skipBracket() {
        const char close = text_[at_] == '(' ? ')' : text_[at_] == '{' ? '}' : ']';
        for (++at_; at_ < end_ && text_[at_] != close;)
            if (!skipBlank()) skipItem();
        at_ = std::min(at_ + 1, end_);
    }

    Span entry() {
        Span span;
        span.begin = at_;
        if (text_[at_] == '#') return directive(span);
        if (text_[at_] == '"') {
            skipString();
            span.key = text_.substr(span.begin + 1, at_ - span.begin - 2);
        } else {
            while (at_ < end_ && !std::isspace(static_cast<unsigned char>(text_[at_])) &&
                   std::string(";{}\"").find(text_[at_]) == std::string::npos)
                text_[at_] == '(' ? skipBracket() : static_cast<void>(++at_);
            span.key = text_.substr(span.begin, at_ - span.begin);
        }
        if (at_ == span.begin) ++at_;  // a stray bracket
        skipBlanks();
        if (at_ < end_ && text_[at_] == '{') {
            span.isDict = true;
            span.valueBegin = at_ + 1;
            skipBracket();
            span.valueEnd = at_ - 1;
        } else {
            span.valueBegin = span.valueEnd = at_;
            while (at_ < end_ && text_[at_] != ';' && text_[at_] != '}') {
                if (skipBlank()) continue;
                skipItem();
                span.valueEnd = at_;
            }
            if (at_ < end_ && text_[at_] == ';') ++at_;
        }
        span.end = at_;
        return span;
    }

    /// #include and the like: the line, or a block in braces.
    Span directive(Span span) {
        while (at_ < end_ && text_[at_] != '\n' && text_[at_] != '{' && text_[at_] != '}')
            text_[at_] == '"' ? skipString() : static_cast<void>(++at_);
        if (at_ < end_ && text_[at_] == '{') skipBracket();
        span.end = at_;
        return span;
    }

    const std::string& text_;
    std::size_t at_, end_;
};

/// A dictionary in the text: what is between its braces.
struct Scope {
    std::size_t begin = 0, end = 0;
    bool top = false;
};

std::vector<Span> entriesOf(const std::string& text, const Scope& scope) {
    return Scanner(text, scope.begin, scope.end).entries();
}

std::vector<Span> named(const std::string& text, const Scope& scope, const std::string& key) {
    auto all = entriesOf(text, scope);
    std::erase_if(all, [&](const Span& span) { return span.key != key; });
    return all;
}

/// All places where the dictionary of the path is written: a dictionary may be continued further down.
std::vector<Scope> scopesOf(const std::string& text, const std::vector<std::string>& path) {
    std::vector<Scope> scopes{{byteOrderMark(text), text.size(), true}};
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        std::vector<Scope> inner;
        for (const auto& scope : scopes)
            for (const auto& span : named(text, scope, path[i]))
                if (span.isDict) inner.push_back({span.valueBegin, span.valueEnd, false});
        scopes = std::move(inner);
    }
    return scopes;
}

std::vector<Scope> demandScopes(const std::string& text, const std::vector<std::string>& path,
                                const std::string& file) {
    auto scopes = scopesOf(text, path);
    if (scopes.empty())
        throw UserError("the dictionary around entry '" + path.back() +
                            "' is not written in this file, but included or copied by a macro",
                        {file, 0});
    return scopes;
}

void checkValue(const std::string& value, const std::string& file) {
    try {
        const bool isDict = value.starts_with('{');
        const Dictionary probe = Dictionary::parse(isDict ? "x " + value : "x " + value + ";", "value");
        if (probe.keys() == std::vector<std::string>{"x"}) return;
    } catch (const UserError&) {
        if (value.find('$') != std::string::npos || value.find('#') != std::string::npos)
            return;  // judged in its place
    }
    throw UserError("'" + value + "' is not a value", {file, 0});
}

/// The blanks at the beginning of the line of `at`.
std::string indentAt(const std::string& text, std::size_t at) {
    const auto line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 = 0
    const auto end = text.find_first_not_of(" \t", line);
    return text.substr(line, std::min(end, at) - line);
}

/// A new entry behind the last one of the scope.
std::string inserted(std::string text, const Scope& scope, const std::string& key, const std::string& value) {
    const auto entries = entriesOf(text, scope);
    const bool isDict = value.starts_with('{');
    const std::string word = key.find_first_of("*|[]+?^$\\") == std::string::npos ? key : '"' + key + '"';  // patterns
    const std::string entry = (word.size() < 15 && !isDict ? word + std::string(16 - word.size(), ' ') : word + " ") +
                              value + (isDict ? "" : ";");
    if (entries.empty() && scope.top) return text + entry + "\n";
    if (entries.empty()) {
        const std::string outer = indentAt(text, scope.begin - 1);
        return text.replace(scope.begin, scope.end - scope.begin, "\n" + outer + "    " + entry + "\n" + outer);
    }
    const bool sameLine = text.find('\n', scope.begin) >= scope.end;
    auto at = entries.back().end;
    if (sameLine && !scope.top) return text.insert(at, " " + entry);
    const std::string indent = indentAt(text, entries.back().begin);
    at = std::min(text.find('\n', at), scope.end);  // a comment behind the last entry stays with it
    return text.insert(at, "\n" + indent + entry);
}

}  // namespace

std::string setEntry(const std::string& text, const std::vector<std::string>& path, const std::string& value,
                     const std::string& file) {
    checkValue(value, file);
    const auto scopes = demandScopes(text, path, file);
    std::optional<Span> last;
    for (const auto& scope : scopes)
        for (const auto& span : named(text, scope, path.back()))
            if (!last || span.begin > last->begin) last = span;
    if (!last) return inserted(text, scopes.back(), path.back(), value);
    const bool isDict = value.starts_with('{');
    std::string changed = text;
    if (last->isDict && isDict)
        return changed.replace(last->valueBegin - 1, last->valueEnd - last->valueBegin + 2, value);
    if (!last->isDict && !isDict && last->valueEnd > last->valueBegin)
        return changed.replace(last->valueBegin, last->valueEnd - last->valueBegin, value);
    const std::string key = text.substr(last->begin, last->key.size() + (text[last->begin] == '"' ? 2 : 0));
    return changed.replace(last->begin, last->end - last->begin, key + " " + value + (isDict ? "" : ";"));
}

std::string addEntry(const std::string& text, const std::vector<std::string>& path, const std::string& value,
                     const std::string& file) {
    for (const auto& scope : demandScopes(text, path, file))
        if (!named(text, scope, path.back()).empty())
            throw UserError("entry '" + path.back() + "' is there already: use -set to change it", {file, 0});
    return setEntry(text, path, value, file);
}

std::string removeEntry(std::string text, const std::vector<std::string>& path, const std::string& file) {
    std::vector<Span> spans;
    for (const auto& scope : demandScopes(text, path, file))
        for (const auto& span : named(text, scope, path.back())) spans.push_back(span);
    if (spans.empty()) throw UserError("entry '" + path.back() + "' is not written in this file", {file, 0});
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.begin > b.begin; });
    for (const auto& span : spans) {
        auto begin = span.begin, end = span.end;
        const auto line = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
        const bool first = text.find_first_not_of(" \t", line) >= begin;
        auto next = text.find_first_not_of(" \t", end);
        if (next != std::string::npos && text.compare(next, 2, "//") == 0) next = text.find('\n', next);
        if (next == std::string::npos) next = text.size();
        if (first && (next == text.size() || text[next] == '\n')) {  // alone on its lines
            begin = line;
            end = std::min(next + 1, text.size());
        }
        text.erase(begin, end - begin);
    }
    return text;
}

}  // namespace pfem
