// Shows and changes what a dictionary says: with macros and includes resolved, one entry, or the keywords.

#include <iostream>

#include "application/runApplication.hpp"
#include "base/atomicFile.hpp"
#include "dictionary/dictionary.hpp"
#include "dictionary/edit.hpp"
#include "dictionary/print.hpp"

using namespace pfem;

namespace {

OptionsSpec dictionaryOptions() {
    OptionsSpec spec;
    spec.arguments = {"file"};
    spec.add("entry", "a/b", "Only this entry; names separated by '/' or '.'");
    spec.add("expand", "", "All entries with macros and includes resolved (default)");
    spec.add("keywords", "", "The keywords only");
    spec.add("value", "", "The value of the entry without its keyword");
    spec.add("set", "value", "Give the entry this value, or add it: comments and layout of the file stay");
    spec.add("add", "value", "Add the entry; an error when it is there already");
    return spec.add("remove", "", "Remove the entry");
}

bool isQuoted(const std::string& key) { return key.size() > 2 && key.front() == '"' && key.back() == '"'; }

std::string lastName(const std::string& entry) { return entry.substr(entry.rfind('/') + 1); }

/// The entry's scopes and, last, its name. Keys may contain dots themselves: these part only where the whole
/// name is no key. In quotes it is one name.
std::vector<std::string> pathOf(std::string key, Dictionary dictionary) {
    std::vector<std::string> path;
    const auto descend = [&](std::size_t cut) {
        path.push_back(key.substr(0, cut));
        dictionary = Dictionary(dictionary.subDict(path.back()));
        key.erase(0, cut + 1);
    };
    for (auto cut = key.find('/'); cut != std::string::npos; cut = key.find('/')) descend(cut);
    if (isQuoted(key)) {
        path.push_back(key.substr(1, key.size() - 2));
        return path;
    }
    for (auto cut = key.find('.'); cut != std::string::npos && !dictionary.found(key); cut = key.find('.')) {
        if (!dictionary.isDict(key.substr(0, cut))) break;
        descend(cut);
    }
    path.push_back(key);
    return path;
}

void show(const Options& options, Dictionary dictionary, const std::vector<std::string>& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) dictionary = Dictionary(dictionary.subDict(path[i]));
    const std::string key = path.empty() ? "" : path.back();
    const bool isDict = key.empty() || dictionary.isDict(key);
    if (isDict && !key.empty()) dictionary = Dictionary(dictionary.subDict(key));
    if (options.found("keywords")) {
        for (const auto& word : dictionary.keys()) std::cout << word << '\n';
    } else if (isDict) {
        print(std::cout, dictionary);
    } else if (options.found("value")) {
        std::cout << valueText(dictionary, key) << '\n';
    } else {
        std::cout << key << ' ' << valueText(dictionary, key) << ";\n";
    }
}

/// A new entry whose name still has a dot was meant to be in a dictionary that is not there.
void demandScope(const std::string& file, Dictionary dictionary, const std::vector<std::string>& path) {
    std::string around;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        dictionary = Dictionary(dictionary.subDict(path[i]));
        around += path[i] + "/";
    }
    const std::string& key = path.back();
    const auto dot = key.find('.');
    if (dot == std::string::npos || dictionary.found(key)) return;
    const std::string scope = key.substr(0, dot), entry = key.substr(dot + 1);
    throw UserError("there is no dictionary '" + scope + "' for entry '" + entry + "': add it first, -entry " + around +
                        scope + " -set '{ " + entry + " ...; }'. A keyword with a dot is written in quotes, -entry '" +
                        around + "\"" + key + "\"'",
                    {file, 0});
}

/// Write the changed text once it has proved to be a dictionary.
void change(const Options& options, const std::string& file, const std::vector<std::string>& path) {
    std::string text = readText(file);
    if (options.found("remove"))
        text = removeEntry(text, path, file);
    else if (options.found("add"))
        text = addEntry(text, path, options.get("add"), file);
    else
        text = setEntry(text, path, options.get("set"), file);
    Dictionary::parse(text, file);
    writeAtomically(file, text);
}

}  // namespace

int main(int argc, char** argv) {
    return runApplication(
        argc, argv, "Show or change the entries of a dictionary.", dictionaryOptions(), [](const Options& options) {
            const std::string& file = options.arguments().front();
            const int changes = options.found("set") + options.found("add") + options.found("remove");
            if (changes > 1) throw UserError("only one of -set, -add and -remove at a time");
            if (changes > 0 && !options.found("entry")) throw UserError("which entry? -entry <a/b>");
            const Dictionary dictionary = Dictionary::read(file);
            const auto path =
                options.found("entry") ? pathOf(options.get("entry"), dictionary) : std::vector<std::string>{};
            if (changes == 0) {
                show(options, dictionary, path);
                return 0;
            }
            if (!options.found("remove") && !isQuoted(lastName(options.get("entry"))))
                demandScope(file, dictionary, path);
            change(options, file, path);
            return 0;
        });
}
