#pragma once
// One declaration of a keyword serves reading, checking and documentation.
//
// A struct of options lists its entries once:
//
//     struct Convergence {
//         double tolU = 1e-4;
//         int maxIterations = 40;
//         std::string norm = "L2";
//         template <class Visitor>
//         void entries(Visitor& v) {
//             v("tolU", tolU, "-", "relative change of velocity at which the iteration stops", positive);
//             v("maxIterations", maxIterations, "-", "iterations before the step is rejected", atLeast(1));
//             v("norm", norm, "-", "norm of the change", oneOf({"L2", "max"}));
//         }
//     };
//
// The member's initial value is the documented default. `readEntries(dict, options)` reads what is there;
// `describeEntries<Convergence>()` gives the rows of the keyword reference. An entry without a default is
// declared with v.required(...), which takes the same arguments.
// Members: bool, int, std::int64_t, double, std::string, Eigen::Vector3d and std::vector of these.

#include <string>
#include <vector>

#include "dictionary/dictionary.hpp"
#include "dictionary/range.hpp"

namespace pfem {

/// A row of the keyword reference.
struct EntryDescription {
    std::string name, type, unit, defaultValue, meaning, range;
};

namespace entriesDetail {

/// "scalar", "word", "vector", ...; and the value as it would be written in a dictionary.
template <class T>
std::string typeName();
template <class T>
std::string valueText(const T& value);

/// Fatal IO error with file, line, entry and range if the value lies outside.
template <class T>
void check(const Dictionary& dictionary, const std::string& key, const T& value, const Range& range);

class Reader {
public:
    explicit Reader(const Dictionary& dictionary) : dictionary_(dictionary) {}

    template <class T>
    void operator()(const std::string& key, T& member, const std::string&, const std::string&,
                    const Range& range = any) {
        member = dictionary_.get(key, member);
        check(dictionary_, key, member, range);
    }
    template <class T>
    void required(const std::string& key, T& member, const std::string&, const std::string&, const Range& range = any) {
        member = dictionary_.get<T>(key);
        check(dictionary_, key, member, range);
    }

private:
    const Dictionary& dictionary_;
};

class Describer {
public:
    std::vector<EntryDescription> rows;

    template <class T>
    void operator()(const std::string& key, const T& member, const std::string& unit, const std::string& meaning,
                    const Range& range = any) {
        rows.push_back({key, typeName<T>(), unit, valueText(member), meaning, range.text});
    }
    template <class T>
    void required(const std::string& key, const T&, const std::string& unit, const std::string& meaning,
                  const Range& range = any) {
        rows.push_back({key, typeName<T>(), unit, "required", meaning, range.text});
    }
};

}  // namespace entriesDetail

template <class Options>
void readEntries(const Dictionary& dictionary, Options& options) {
    entriesDetail::Reader reader(dictionary);
    options.entries(reader);
}

template <class Options>
Options readEntries(const Dictionary& dictionary) {
    Options options;
    readEntries(dictionary, options);
    return options;
}

template <class Options>
std::vector<EntryDescription> describeEntries() {
    Options options;
    entriesDetail::Describer describer;
    options.entries(describer);
    return describer.rows;
}

}  // namespace pfem
