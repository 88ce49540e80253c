#pragma once
// Changes in the text of a dictionary that leave comments, layout and macros as they are.

#include <string>
#include <vector>

namespace pfem {

/// Give an entry another value; add it when it is not there. `path`: the dictionaries around it, outermost
/// first, and its keyword. `value`: without ';', or a whole dictionary in braces. Of entries that stand twice
/// the last one counts. Throws UserError (naming `file`) when a dictionary of the path is not written in this
/// text (but included, or copied by a macro), or the value is none.
std::string setEntry(const std::string& text, const std::vector<std::string>& path, const std::string& value,
                     const std::string& file);

/// The same for an entry that is not there yet. Throws UserError when it is.
std::string addEntry(const std::string& text, const std::vector<std::string>& path, const std::string& value,
                     const std::string& file);

/// Remove all occurrences of the entry with the blanks and the comment behind it on its line. Throws
/// UserError when there is none.
std::string removeEntry(std::string text, const std::vector<std::string>& path, const std::string& file);

}  // namespace pfem
