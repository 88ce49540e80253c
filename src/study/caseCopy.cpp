#include "study/caseCopy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "dictionary/edit.hpp"
#include "dictionary/files.hpp"
#include "dictionary/flatEntries.hpp"
#include "dictionary/print.hpp"
#include "io/textHeader.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

const fs::path controlDict = "system/controlDict", sweepDict = "system/sweepDict";

bool isDictionary(const fs::path& file) {
    static const std::set<std::string> names{"constant/materials",  "constant/g",      "constant/boundaryConditions",
                                             "system/pfemSolution", "system/meshDict", "system/controlDict"};
    return names.contains(file.string());
}

/// Files of constant/ and system/, relative to the case; pfemSolution in any case.
std::vector<fs::path> filesOf(const fs::path& root) {
    std::set<fs::path> files{"system/pfemSolution"};
    for (const char* folder : {"constant", "system"}) {
        std::error_code error;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder, error))
            if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), root));
    }
    files.erase(sweepDict);
    return {files.begin(), files.end()};
}

/// The dictionary's text with all macros and includes resolved, so that it says the same in another folder.
std::string resolved(const Overlay& changed, const fs::path& file) {
    std::ostringstream text;
    if (changed.contains(fs::weakly_canonical(file)) || fs::exists(file)) print(text, readWith(changed, file));
    return text.str() + "\n" + dictionaryEndLine();
}

using Flat = std::map<std::string, std::string>;

/// What a copy with results may not differ in.
Flat binding(const CaseCopy& copy, const fs::path& file, const std::string& text) {
    if (!isDictionary(file)) return {{"text", text}};
    if (file == controlDict && copy.freeControls.empty()) return {};
    Flat flat = flatEntries(Dictionary::parse(text, file.string()));
    if (file == controlDict)
        std::erase_if(flat, [&](const auto& entry) {
            return std::find(copy.freeControls.begin(), copy.freeControls.end(), entry.first) !=
                   copy.freeControls.end();
        });
    return flat;
}

void demandSame(const CaseCopy& copy, const fs::path& file, const std::string& before, const std::string& now) {
    const Flat was = binding(copy, file, before), is = binding(copy, file, now);
    if (was == is) return;
    throw UserError(fmt::format("\"{}\" has results of another \"{}\": remove that folder, or use -overwrite{}",
                                copy.root.string(), file.string(),
                                isDictionary(file) ? ". What differs:\n" + differences(was, is) : ""));
}

/// Files that the case does not have any more.
void clearRemoved(const CaseCopy& copy, const std::vector<fs::path>& files, bool hasResults, Copying how) {
    for (const auto& file : filesOf(copy.root)) {
        if (std::binary_search(files.begin(), files.end(), file)) continue;
        if (hasResults) demandSame(copy, file, readText(copy.root / file), "");
        if (how != Copying::compareOnly) fs::remove(copy.root / file);
    }
}

void write(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw UserError("cannot make the folder: " + error.message(), {file.parent_path().string(), 0});
    writeAtomically(file, text);
}

}  // namespace

Overlay changedTexts(const fs::path& root, const std::vector<Change>& changes) {
    Overlay texts;
    for (const auto& change : changes) {
        const fs::path file = fs::weakly_canonical(root / change.file);
        if (!texts.contains(file)) texts[file] = fs::exists(file) ? fileText(file, {}) : "";
        texts[file] = setEntry(texts[file], change.path, change.value, file.string());
    }
    return texts;
}

void makeCopy(const Case& theCase, const CaseCopy& copy, Copying how) {
    if (how == Copying::overwrite) fs::remove_all(copy.root);
    const bool hasResults = !listTimes(copy.root).complete.empty();
    auto changes = copy.changes;
    changes.push_back({controlDict, {"startFrom"}, "latestTime"});
    const Overlay changed = changedTexts(theCase.root(), changes);
    const auto files = filesOf(theCase.root());
    clearRemoved(copy, files, hasResults, how);
    for (const auto& file : files) {
        const fs::path source = theCase.root() / file, target = copy.root / file;
        const std::string text = isDictionary(file) ? resolved(changed, source) : readText(source);
        const bool there = fs::exists(target);
        const std::string before = there ? readText(target) : "";
        if (there && before == text) continue;
        if (hasResults) demandSame(copy, file, before, text);
        if (how != Copying::compareOnly) write(target, text);
    }
}

std::vector<fs::path> sourcesOf(const Case& theCase) {
    std::set<fs::path> sources;
    for (const auto& file : filesOf(theCase.root())) {
        if (!isDictionary(file) || !fs::exists(theCase.root() / file)) continue;
        for (const auto& name : filesOf(Dictionary::read(theCase.root() / file))) {
            const fs::path source = fs::relative(fs::weakly_canonical(name), fs::weakly_canonical(theCase.root()));
            if (*source.begin() != "..") sources.insert(source);
        }
    }
    return {sources.begin(), sources.end()};
}

}  // namespace pfem
