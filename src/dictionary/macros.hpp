#pragma once
// What $name stands for.
//
//     $a ${a} $sub.key     from here outwards through the enclosing dictionaries, then the environment
//     $.a  $..a  $...a     this dictionary only, its parent, its grand-parent
//     $:a.b  $^a.b  $/a/b  from the top of the file
//     $../a  $!a/b         the same with slashes
//     ${a:-text}           text if there is no a;   ${a:+text}  text if there is one

#include <string>

#include "dictionary/node.hpp"

namespace pfem {

/// The entry a macro names, or null; it counts as used from now on. `name` without "$" and braces.
/// Quoted keys count as patterns for `$dict;` only: in `".*" { value $internalField; }` the value is not the
/// pattern.
const DictionaryEntry* findMacro(const DictionaryNode& scope, const std::string& name, bool patterns = false);

/// ${name:-default}: the parts. `operation` is '-', '+' or '\0' if there is none.
struct MacroDefault {
    std::string name;
    char operation = '\0';
    std::string text;
};
MacroDefault splitDefault(const std::string& name);

/// Text with its $macros replaced. Unknown ones stay as they are: a '$' in a title is no error.
/// Numbers in `inExpression` are put in parentheses where needed ("2-$a" with a = -1).
/// UserError at `where` if the text grows without bounds.
std::string expandString(const std::string& text, const DictionaryNode& scope, const Location& where,
                         bool inExpression = false, int depth = 0);

}  // namespace pfem
