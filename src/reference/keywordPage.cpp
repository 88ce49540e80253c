#include <fmt/format.h>

#include "reference/keywords.hpp"

namespace pfem {

namespace {

/// What stands in a cell: a bar would end it.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + cell(text) + "`"; }

std::string row(const EntryDescription& entry) {
    const bool value = entry.defaultValue != "required" && entry.defaultValue != "optional";
    return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", entry.name, entry.type, entry.unit,
                       value ? code(entry.defaultValue) : entry.defaultValue, cell(entry.range), cell(entry.meaning));
}

}  // namespace

std::vector<KeywordTable> keywordTables() {
    std::vector<KeywordTable> all;
    for (auto part : {systemKeywords, functionKeywords, meshKeywords, spaceMeshKeywords, sweepKeywords,
                      constantKeywords, conditionKeywords})
        for (auto& table : part()) all.push_back(std::move(table));
    return all;
}

std::string keywordPage() {
    std::string text =
        "# Keywords\n\nEvery entry of the dictionaries of a case. This page is made by the programs "
        "themselves "
        "(`pfemMesh -help-keywords`) from the\ndeclarations by which they read. An entry with a default may "
        "be left out.\n";
    std::string file;
    for (const auto& table : keywordTables()) {
        if (table.file != file) text += "\n## " + table.file + "\n";
        file = table.file;
        if (!table.place.empty()) text += "\n### " + table.place + "\n";
        text += "\n" + table.meaning + "\n";
        if (table.rows.empty()) continue;
        text += "\n| entry | type | unit | default | range | meaning |\n| --- | --- | --- | --- | --- | --- |\n";
        for (const auto& entry : table.rows) text += row(entry);
    }
    return text;
}

}  // namespace pfem
