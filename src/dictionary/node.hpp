#pragma once
// The storage behind Dictionary. Only the files of this folder know it.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "dictionary/dictionary.hpp"
#include "dictionary/keyPattern.hpp"
#include "dictionary/token.hpp"

namespace pfem {

struct DictionaryEntry {
    std::string key;
    bool quoted = false;
    std::optional<KeyPattern> pattern;
    Tokens tokens;
    std::shared_ptr<Dictionary> dict;  ///< null: a primitive entry
    Location where;
    bool used = false;
    bool inMacro = false;    ///< a macro took its value: not reported as unused
    bool readWhole = false;  ///< read as raw tokens: what is in it is not reported as unused
};

struct DictionaryNode {
    std::string name;     ///< file and dotted scope
    std::string keyword;  ///< last part of the name
    Location where;
    std::weak_ptr<DictionaryNode> parent;
    std::vector<DictionaryEntry> entries;  ///< in file order
    std::unordered_map<std::string, std::size_t> index;
    std::set<std::string> lookedUp;
    std::unordered_map<std::string, std::shared_ptr<Dictionary>> empties;  ///< of subDictOrEmpty

    /// Exact key first, then patterns, the last one of the file first; null if there is none.
    DictionaryEntry* find(const std::string& key, bool patterns = true);
    void add(DictionaryEntry entry);
    void remove(const std::string& key);
};

using NodePtr = std::shared_ptr<DictionaryNode>;

inline const char* const headerKey = "FoamFile";

/// A sub-dictionary of `parent` (which may be null), still empty and not yet entered in it.
NodePtr makeNode(const NodePtr& parent, const std::string& keyword, const Location& where);

/// A deep copy under a new parent and keyword. `budget` is reduced by the number of copied tokens and
/// entries; at zero, or beyond the deepest nesting, a UserError at `where`.
NodePtr copyNode(const DictionaryNode& from, const NodePtr& parent, const std::string& keyword, const Location& where,
                 long& budget, int depth = 0);

/// Enters all entries of `from` into `to`: later values win, dictionaries merge.
void mergeInto(const NodePtr& to, const NodePtr& from);

int depthOf(NodePtr node);
inline constexpr int maxDepth = 200;

}  // namespace pfem
