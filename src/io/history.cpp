#include "io/history.hpp"

#include <fmt/format.h>

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

TableText readTable(const fs::path& file, double time) {
    const std::string text = readText(file), now = timeText(time);
    TableText table;
    for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        const std::string line = text.substr(begin, end - begin);
        std::string first;
        std::istringstream(line) >> first;
        if (first.empty()) continue;
        if (first[0] == '#') {
            if (table.rows.empty()) table.head.push_back(line);
            continue;
        }
        const auto value = asNumber(first);
        if (!value || (*value > time && first != now)) break;
        table.rows.push_back(line);
    }
    return table;
}

}  // namespace pfem
