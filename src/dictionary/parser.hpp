#pragma once
// Reads entries from tokens into a DictionaryNode; macros and directives act while reading, as in OpenFOAM.

#include <filesystem>

#include "dictionary/lexer.hpp"
#include "dictionary/node.hpp"
#include "dictionary/overlay.hpp"

namespace pfem {

class Parser {
public:
    explicit Parser(Overlay changed = {}) : changed_(std::move(changed)) {}

    void readFile(const std::filesystem::path& file, const NodePtr& into);
    void readText(const std::string& text, const std::string& name, const NodePtr& into);

private:
    enum class InputMode { merge, overwrite, protect, warn, error };

    // parser.cpp
    void entries(Lexer& lexer, const NodePtr& node, const Token& openBrace);
    void entry(Lexer& lexer, const NodePtr& node, const Token& key);
    NodePtr dictionary(Lexer& lexer, const NodePtr& parent, const std::string& keyword, const Token& openBrace);
    void value(Lexer& lexer, const NodePtr& scope, const Token& key, Tokens& out, bool untilEnd = false);
    void add(const NodePtr& node, DictionaryEntry entry);
    void spend(std::size_t tokens, const Location& where);

    // substitution.cpp: $macros
    void substitute(Lexer& lexer, const NodePtr& node, const Token& variable);
    void appendVariable(const NodePtr& scope, const Token& variable, Tokens& out);
    std::string variableAsWord(const NodePtr& scope, const Token& variable);

    // directives.cpp: #directives
    void directive(Lexer& lexer, const NodePtr& node, const Token& token);
    void valueDirective(Lexer& lexer, const NodePtr& scope, const Token& token, const Token& key, Tokens& out);
    void evaluate(Lexer& lexer, const NodePtr& scope, const Token& token, Tokens& out);
    std::filesystem::path includedFile(Lexer& lexer, const NodePtr& scope, const Token& token);
    std::string textOf(const std::filesystem::path& file, const Location& where) const;
    Lexer openFile(const std::filesystem::path& file, const Token& token);
    void includeFile(const std::filesystem::path& file, const NodePtr& node, const Token& token);
    void include(Lexer& lexer, const NodePtr& node, const Token& token);
    void includeFunction(Lexer& lexer, const NodePtr& node, const Token& token);
    void removeKeys(Lexer& lexer, const NodePtr& node, const Token& token);
    void setInputMode(Lexer& lexer, const Token& token);

    // conditions.cpp: #if #ifeq #else #endif
    bool condition(Lexer& lexer, const NodePtr& scope, const Token& token);
    /// Skips to the #else or #endif of an #if; true if it was #else.
    bool skipBranch(Lexer& lexer, const Token& token, bool elseCounts);

    InputMode mode_ = InputMode::merge;
    Overlay changed_;                          ///< what counts instead of files
    std::vector<std::filesystem::path> open_;  ///< the including files
    long budget_ = 1'000'000;                  ///< tokens that macros may still produce
};

}  // namespace pfem
