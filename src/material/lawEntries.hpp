#pragma once
// Entries of laws, read: numbers may have their dimensions before them, which are checked against the declared unit.

#include <map>

#include "dictionary/entries.hpp"

namespace pfem {

/// The exponents of kg m s K mol A cd of a unit as declarations write it: "kg/m3", "Pa s", "-". An exponent may be an
/// entry that was read before: "Pa s^n" with exponents {n: 0.5}.
std::array<double, 7> dimensionsOfUnit(const std::string& unit, const std::map<std::string, double>& exponents);

/// The reading visitor of entries(Visitor&); see dictionary/entries.hpp.
class LawReader {
public:
    explicit LawReader(const Dictionary& dictionary) : dictionary_(dictionary) {}

    template <class T>
    void operator()(const std::string& key, T& member, const std::string& unit, const std::string& meaning,
                    const Range& range = any) {
        if (dictionary_.found(key)) required(key, member, unit, meaning, range);
    }
    template <class T>
    void required(const std::string& key, T& member, const std::string& unit, const std::string&,
                  const Range& range = any) {
        if constexpr (std::is_same_v<T, double>)
            member = number_[key] = dictionary_.dimensioned(key, dimensionsOfUnit(unit, number_));
        else
            member = dictionary_.get<T>(key);
        entriesDetail::check(dictionary_, key, member, range);
    }

private:
    const Dictionary& dictionary_;
    std::map<std::string, double> number_;  // what has been read
};

/// A law with the entries of `dictionary`. Throws UserError with file, line and entry; also when the law has a fault():
/// what is wrong with entries that are each for itself in their range.
template <class Law>
Law readLaw(const Dictionary& dictionary) {
    Law law;
    LawReader reader(dictionary);
    law.entries(reader);
    if constexpr (requires { law.fault(); })
        if (const std::string fault = law.fault(); !fault.empty()) dictionary.fatal("type", fault);
    return law;
}

}  // namespace pfem
