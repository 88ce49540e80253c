#include "functions/functionEntries.hpp"

#include <algorithm>
#include <set>

#include "functions/functionObject.hpp"

namespace pfem {

namespace {

std::vector<Dictionary> inOrder(const Dictionary& dict) {
    if (!dict.found("functions")) return {};
    if (!dict.isDict("functions")) return dict.dictList("functions");
    const Dictionary& functions = dict.subDict("functions");
    std::vector<Dictionary> entries;
    for (const auto& name : functions.keys()) {
        if (!functions.isDict(name)) functions.fatal(name, "'" + name + "' in functions is not a dictionary");
        entries.push_back(functions.subDict(name));
    }
    return entries;
}

}  // namespace

std::vector<Dictionary> functionEntries(const Dictionary& dict) {
    auto entries = inOrder(dict);
    std::set<std::string> names;
    for (const auto& entry : entries) {
        const std::string name = entry.keyword();
        if (name.empty())
            throw UserError("a function in the list 'functions' has no name: functions ( name { ... } );",
                            entry.where());
        if (name[0] == '.' || name.find_first_of("/\"\n") != std::string::npos)
            throw UserError("'" + name + "' in functions cannot be the name of a folder in postProcessing",
                            entry.where());
        if (!names.insert(name).second)
            throw UserError("'" + name + "' is twice in the list 'functions'", entry.where());
    }
    return entries;
}

void takeAsRead(const Dictionary& entry) {
    for (const auto& key : entry.keys()) {
        if (entry.isDict(key))
            takeAsRead(entry.subDict(key));
        else
            entry.reader(key);
    }
}

bool isForeignFunction(const Dictionary& entry) {
    const auto types = functionTypes();
    const auto type = entry.get<std::string>("type");
    return std::find(types.begin(), types.end(), type) == types.end() && nearestWord(type, types).empty();
}

}  // namespace pfem
