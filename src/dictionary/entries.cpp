#include "dictionary/entries.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pfem {

Range atLeast(double n) { return {.text = fmt::format(">= {}", n), .lower = n, .words = {}}; }
Range atMost(double n) { return {.text = fmt::format("<= {}", n), .upper = n, .words = {}}; }
Range between(double a, double b) {
    return {.text = fmt::format("{} to {}", a, b), .lower = a, .upper = b, .words = {}};
}
Range oneOf(std::vector<std::string> words) {
    return {.text = fmt::format("one of: {}", fmt::join(words, " ")), .words = std::move(words)};
}

namespace entriesDetail {

namespace {

std::string text(bool value) { return value ? "yes" : "no"; }
std::string text(const std::string& value) { return value.empty() ? "\"\"" : value; }
std::string text(const Eigen::Vector3d& v) { return fmt::format("({} {} {})", v[0], v[1], v[2]); }
std::string text(int value) { return std::to_string(value); }
std::string text(std::int64_t value) { return std::to_string(value); }
std::string text(double value) { return fmt::format("{}", value); }

template <class T>
std::string text(const std::vector<T>& values) {
    std::string result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) result += ' ';
        result += text(T(values[i]));
    }
    return fmt::format("({})", result);
}

bool allowed(bool, const Range&) { return true; }
bool allowed(double value, const Range& range) { return range.holds(value); }
bool allowed(int value, const Range& range) { return range.holds(value); }
bool allowed(std::int64_t value, const Range& range) { return range.holds(static_cast<double>(value)); }
bool allowed(const Eigen::Vector3d& v, const Range& range) {
    return range.holds(v[0]) && range.holds(v[1]) && range.holds(v[2]);
}
bool allowed(const std::string& word, const Range& range) {
    return range.words.empty() || std::find(range.words.begin(), range.words.end(), word) != range.words.end();
}
template <class T>
bool allowed(const std::vector<T>& values, const Range& range) {
    return std::all_of(values.begin(), values.end(), [&](const T& value) { return allowed(value, range); });
}

std::string name(bool*) { return "bool"; }
std::string name(int*) { return "int"; }
std::string name(std::int64_t*) { return "int"; }
std::string name(double*) { return "scalar"; }
std::string name(std::string*) { return "word"; }
std::string name(Eigen::Vector3d*) { return "vector"; }
template <class T>
std::string name(std::vector<T>*) {
    return "list of " + name(static_cast<T*>(nullptr));
}

}  // namespace

template <class T>
std::string typeName() {
    return name(static_cast<T*>(nullptr));
}

template <class T>
std::string valueText(const T& value) {
    return text(value);
}

template <class T>
void check(const Dictionary& dictionary, const std::string& key, const T& value, const Range& range) {
    if (allowed(value, range)) return;
    if constexpr (std::is_same_v<T, std::string>) {
        dictionary.fatal(key, notValid(value, key, range.words));
    } else {
        dictionary.fatal(key, fmt::format("Entry '{}' in dictionary \"{}\" is out of range: {}, should be {}", key,
                                          dictionary.name(), text(value), range.text));
    }
}

#define PFEM_ENTRY_TYPE(T)                       \
    template std::string typeName<T>();          \
    template std::string valueText<T>(const T&); \
    template void check<T>(const Dictionary&, const std::string&, const T&, const Range&);

PFEM_ENTRY_TYPE(bool)
PFEM_ENTRY_TYPE(int)
PFEM_ENTRY_TYPE(std::int64_t)
PFEM_ENTRY_TYPE(double)
PFEM_ENTRY_TYPE(std::string)
PFEM_ENTRY_TYPE(Eigen::Vector3d)
PFEM_ENTRY_TYPE(std::vector<bool>)
PFEM_ENTRY_TYPE(std::vector<int>)
PFEM_ENTRY_TYPE(std::vector<std::int64_t>)
PFEM_ENTRY_TYPE(std::vector<double>)
PFEM_ENTRY_TYPE(std::vector<std::string>)
PFEM_ENTRY_TYPE(std::vector<Eigen::Vector3d>)
PFEM_ENTRY_TYPE(std::vector<std::vector<Eigen::Vector3d>>)

#undef PFEM_ENTRY_TYPE

}  // namespace entriesDetail

}  // namespace pfem
