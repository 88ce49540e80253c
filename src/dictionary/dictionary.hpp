#pragma once
// A dictionary of OpenFOAM's grammar, read from a file of the case.
//
//     const Dictionary control = Dictionary::read(caseDir / "system/controlDict");
//     const double deltaT = control.get<double>("deltaT");
//     const bool adjust = control.get("adjustTimeStep", false);
//
// A Dictionary is a handle: copies share the entries and the record of what was read, from which
// warnUnused() finds misspelt keys. Every error is a UserError with the line of the entry.

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "dictionary/tokenReader.hpp"

namespace pfem {

struct DictionaryNode;
struct DictionaryEntry;

/// An entry which nobody asked for.
struct Unused {
    std::string key;
    Location where;
    std::string suggestion;  ///< the nearest key that was looked up in the same dictionary, or ""
};

class Dictionary {
public:
    static Dictionary read(const std::filesystem::path& file);
    static Dictionary parse(const std::string& text, const std::string& name = "text");

    Dictionary();  ///< empty
    explicit Dictionary(std::shared_ptr<DictionaryNode> node);

    /// File and dotted scope: "/case/system/controlDict.functions.tip".
    const std::string& name() const;
    /// Last part of the name; "" of nameless dictionaries in a list.
    std::string keyword() const;
    Location where() const;
    /// Of the entry, or of the dictionary if there is no such entry.
    Location where(const std::string& key) const;

    /// Exact key first, then patterns in reverse order of the file. Counts as a use of the entry.
    bool found(const std::string& key) const;
    bool isDict(const std::string& key) const;
    /// In file order, without patterns and the FoamFile header.
    std::vector<std::string> keys() const;

    /// T: bool, int, std::int64_t, double, std::string, Eigen::Vector3d, or std::vector of these (also
    /// nested).
    template <class T>
    T get(const std::string& key) const {
        TokenReader tokens = reader(key);
        T value = tokens.read<T>();
        tokens.end();
        return value;
    }
    template <class T>
    T get(const std::string& key, const T& defaultValue) const {
        return has(key) ? get<T>(key) : defaultValue;
    }
    std::string get(const std::string& key, const char* defaultValue) const {
        return get<std::string>(key, std::string(defaultValue));
    }

    const Dictionary& subDict(const std::string& key) const;
    const Dictionary& subDictOrEmpty(const std::string& key) const;
    /// ( {..} {..} ), ( a {..} b {..} ) and { a {..} b {..} }; the name is in keyword().
    std::vector<Dictionary> dictList(const std::string& key) const;

    /// One of the valid words; else fatal with their list and the nearest one.
    std::string choice(const std::string& key, const std::vector<std::string>& valid) const;
    std::string choice(const std::string& key, const std::vector<std::string>& valid,
                       const std::string& defaultWord) const;

    /// `rho 1000;`  `rho [1 -3 0 0 0 0 0] 1000;`  `rho rho [1 -3 0 0 0 0 0] 1000;`
    /// Dimensions, where given, must be the expected ones: exponents of kg m s K mol A cd.
    double dimensioned(const std::string& key, const std::array<double, 7>& dimensions) const;
    double dimensioned(const std::string& key, const std::array<double, 7>& dimensions, double defaultValue) const;

    /// For entries of any other form. Dictionaries within are taken as read.
    TokenReader reader(const std::string& key) const;

    /// UserError at the line of the key, or of the dictionary if there is no such key.
    [[noreturn]] void fatal(const std::string& key, const std::string& message) const;

    /// Entries never read, those of sub-dictionaries included; of unread sub-dictionaries only themselves.
    std::vector<Unused> unused() const;

    const std::shared_ptr<DictionaryNode>& node() const { return node_; }

private:
    /// The entry, or null; notes the look-up.
    DictionaryEntry* find(const std::string& key) const;
    DictionaryEntry& demand(const std::string& key) const;
    bool has(const std::string& key) const { return find(key) != nullptr; }

    std::shared_ptr<DictionaryNode> node_;
};

/// "--> PFEM Warning: entry 'maxC0' in system/controlDict:47 is not used (did you mean 'maxCo'?)"
void warnUnused(const Dictionary& dictionary, std::ostream& out);

}  // namespace pfem
