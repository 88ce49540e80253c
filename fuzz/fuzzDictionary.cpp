// The dictionary parser under any bytes: each text is read with all its entries in all types, printed, and read again.

#include <Eigen/Core>
#include <sstream>

#include "dictionary/dictionary.hpp"
#include "dictionary/flatEntries.hpp"
#include "dictionary/print.hpp"

using namespace pfem;

namespace {

template <class T>
void attempt(const Dictionary& dict, const std::string& key) {
    try {
        dict.get<T>(key);
    } catch (const UserError& error) {
        if (error.where().file.empty()) __builtin_trap();  // each message names the file
    }
}

void readAll(const Dictionary& dict, int depth) {
    for (const auto& key : dict.keys()) {
        if (dict.isDict(key)) {
            if (depth < 50) readAll(dict.subDict(key), depth + 1);
            continue;
        }
        attempt<double>(dict, key);
        attempt<std::int64_t>(dict, key);
        attempt<bool>(dict, key);
        attempt<std::string>(dict, key);
        attempt<Eigen::Vector3d>(dict, key);
        attempt<std::vector<double>>(dict, key);
        attempt<std::vector<std::string>>(dict, key);
        attempt<std::vector<std::vector<Eigen::Vector3d>>>(dict, key);
        try {
            dict.dimensioned(key, {1, -3, 0, 0, 0, 0, 0});
        } catch (const UserError&) {
        }
        try {
            dict.dictList(key);
        } catch (const UserError&) {
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    try {
        const Dictionary dict = Dictionary::parse(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
        readAll(dict, 0);
        flatEntries(dict);
        std::ostringstream text;
        print(text, dict);
        warnUnused(dict, text);
    } catch (const UserError& error) {
        if (error.where().file.empty()) __builtin_trap();
    }
    return 0;
}
