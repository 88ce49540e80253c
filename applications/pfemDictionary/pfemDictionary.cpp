// Shows what a dictionary says: with macros and includes resolved, one entry, or the keywords.

#include <iostream>

#include "dictionary/dictionary.hpp"
#include "dictionary/print.hpp"

namespace {

const char* const usage =
    "Usage: pfemDictionary [OPTIONS] <file>\n"
    "Options:\n"
    "  -entry <a/b>      only this entry; names separated by '/' or '.'\n"
    "  -expand           all entries with macros and includes resolved (default)\n"
    "  -keywords         the keywords only\n"
    "  -value            the value of the entry without its keyword\n"
    "  -help             this text\n";

struct Options {
    std::string file, entry;
    bool keywords = false, value = false;
};

/// False if the program is to end with the usage text.
bool parseArguments(int argc, char** argv, Options& options) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "-expand") continue;
        if (word == "-keywords")
            options.keywords = true;
        else if (word == "-value")
            options.value = true;
        else if (word == "-entry" && i + 1 < argc)
            options.entry = argv[++i];
        else if (!word.starts_with('-') && options.file.empty())
            options.file = word;
        else {
            std::cerr << usage << "\nInvalid option: " << word << '\n';
            return false;
        }
    }
    if (options.file.empty()) std::cerr << usage << "\nA file is needed\n";
    return !options.file.empty();
}

void show(const Options& options) {
    using namespace pfem;
    Dictionary dictionary = Dictionary::read(options.file);
    std::string key = options.entry;
    for (auto cut = key.find('/'); cut != std::string::npos; cut = key.find('/')) {
        dictionary = Dictionary(dictionary.subDict(key.substr(0, cut)));
        key.erase(0, cut + 1);
    }
    // Keys may contain dots themselves: descend only where the whole name is no key.
    for (auto cut = key.find('.'); cut != std::string::npos && !dictionary.found(key); cut = key.find('.')) {
        dictionary = Dictionary(dictionary.subDict(key.substr(0, cut)));
        key.erase(0, cut + 1);
    }
    const bool isDict = key.empty() || dictionary.isDict(key);
    if (isDict && !key.empty()) dictionary = Dictionary(dictionary.subDict(key));
    if (options.keywords) {
        for (const auto& word : dictionary.keys()) std::cout << word << '\n';
    } else if (isDict) {
        print(std::cout, dictionary);
    } else if (options.value) {
        std::cout << valueText(dictionary, key) << '\n';
    } else {
        std::cout << key << ' ' << valueText(dictionary, key) << ";\n";
    }
}

}  // namespace

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "-help") {
            std::cout << usage;
            return 0;
        }
    }
    Options options;
    if (!parseArguments(argc, argv, options)) return 1;
    try {
        show(options);
    } catch (const pfem::UserError& error) {
        std::cerr << "--> FOAM FATAL IO ERROR:\n" << error.what() << "\n\nfile: " << error.where().file;
        if (error.where().lastLine > 0) {
            std::cerr << " from line " << error.where().line << " to line " << error.where().lastLine
                      << ".\n";
        } else {
            std::cerr << " at line " << error.where().line << ".\n";
        }
        std::cerr << "\nFOAM exiting\n";
        return 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
