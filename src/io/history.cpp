#include "io/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "base/atomicFile.hpp"
#include "case/timeFolders.hpp"

namespace pfem {

namespace fs = std::filesystem;

std::optional<fs::path> previousTable(const fs::path& file) {
    const auto start = asNumber(file.parent_path().filename().string());
    std::optional<fs::path> found;
    double latest = 0;
    std::error_code error;
    if (!start) return found;
    for (const auto& folder : fs::directory_iterator(file.parent_path().parent_path(), error)) {
        const auto number = asNumber(folder.path().filename().string());
        const fs::path candidate = folder.path() / file.filename();
        if (!number || *number >= *start || (found && *number <= latest)) continue;
        if (!fs::is_regular_file(candidate, error)) continue;
        found = candidate;
        latest = *number;
    }
    return found;
}

std::string timeText(double time, int precision) { return fmt::format("{:.{}g}", time, precision > 12 ? 17 : 12); }

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> TableText::titles() const {
    return head.empty() ? std::vector<std::string>{} : wordsOf(head.back().substr(head.back().find('#') + 1));
}

bool TableText::ofProbes() const {
    return std::any_of(head.begin(), head.end(), [](const std::string& line) {
        const auto words = wordsOf(line.substr(line.find('#') + 1));
        return !words.empty() && words[0] == "Probe";
    });
}

TableText readTable(const fs::path& file) {
    const std::string text = readText(file);
    TableText table;
    int number = 0;
    for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        const std::string line = text.substr(begin, end - begin);
        ++number;
        const auto first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos) continue;
        if (line[first] == '#') {
            if (table.rows.empty()) table.head.push_back(line);
            continue;
        }
        table.rows.push_back(line);
        table.lineNumber.push_back(number);
    }
    return table;
}

TableText upTo(double time, TableText table) {
    const std::string now = timeText(time);
    std::size_t n = 0;
    for (; n < table.rows.size(); ++n) {
        const std::string first = wordsOf(table.rows[n]).front();
        const auto value = asNumber(first);
        if (!value || (*value > time && first != now)) break;
    }
    table.rows.resize(n);
    table.lineNumber.resize(n);
    return table;
}

std::vector<std::vector<double>> numbersOf(const std::string& row, const Location& where) {
    std::string spaced;
    for (const char c : row) {
        const bool bracket = c == '(' || c == ')';
        if (bracket) spaced += ' ';
        spaced += c;
        if (bracket) spaced += ' ';
    }
    std::vector<std::vector<double>> columns;
    bool inside = false;
    for (const auto& word : wordsOf(spaced)) {
        if (word == "(") columns.emplace_back();
        if (word == "(" || word == ")") {
            inside = word == "(";
            continue;
        }
        const auto value = asNumber(word);
        if (!value) throw UserError("'" + word + "' is not a number", where);
        if (!inside) columns.emplace_back();
        columns.back().push_back(*value);
    }
    return columns;
}

}  // namespace pfem
