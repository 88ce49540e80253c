#include "study/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/error.hpp"
#include "case/timeFolders.hpp"
#include "io/history.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

/// The folders of a function, ascending by their start times.
std::vector<TimeFolder> startFolders(const fs::path& root, const std::string& function) {
    std::vector<TimeFolder> starts;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(root / "postProcessing" / function, error)) {
        const std::string name = entry.path().filename().string();
        if (const auto value = asNumber(name)) starts.push_back({name, *value});
    }
    std::sort(starts.begin(), starts.end(), [](const TimeFolder& a, const TimeFolder& b) { return a.value < b.value; });
    return starts;
}

/// The rows of one table file: the numbers of each column, those of a vector together; NaN for dry probes.
struct Rows {
    bool probes = false;
    std::vector<std::string> titles;
    std::vector<std::vector<std::vector<double>>> columns;  // [row][column][component]
};

Rows readRows(const fs::path& file) {
    const TableText table = readTable(file);
    Rows rows{table.ofProbes(), table.titles(), {}};
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        auto row = numbersOf(table.rows[k], {file.string(), table.lineNumber[k]});
        for (auto& column : row)
            for (double& value : column)
                if (!(value > -1e299)) value = std::numeric_limits<double>::quiet_NaN();
        rows.columns.push_back(std::move(row));
    }
    return rows;
}

std::vector<std::string> components(std::size_t n) {
    if (n == 1) return {""};
    if (n == 3) return {"_x", "_y", "_z"};
    if (n == 6) return {"_xx", "_xy", "_xz", "_yy", "_yz", "_zz"};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < n; ++i) names.push_back(fmt::format("_{}", i));
    return names;
}

std::vector<ProbeHistory> emptyHistories(const Rows& rows, const std::string& file) {
    std::vector<ProbeHistory> histories;
    const auto& first = rows.columns.front();
    for (std::size_t c = 1; c < first.size(); ++c) {
        std::string name = c < rows.titles.size() ? rows.titles[c] : fmt::format("{}_{}", file, c);
        if (rows.probes) name = first.size() > 2 ? fmt::format("{}_{}", c - 1, file) : file;
        for (const auto& component : components(first[c].size())) histories.push_back({name + component, {}});
    }
    return histories;
}

}  // namespace

std::vector<ProbeHistory> readHistories(const fs::path& root, const std::string& function, const std::string& file) {
    std::vector<ProbeHistory> histories;
    const fs::path place = root / "postProcessing" / function;
    for (const auto& start : startFolders(root, function)) {
        if (!fs::exists(place / start.name / file)) continue;
        const Rows rows = readRows(place / start.name / file);
        if (rows.columns.empty()) continue;
        if (histories.empty()) histories = emptyHistories(rows, file);
        const double from = rows.columns.front()[0][0];
        for (ProbeHistory& history : histories)  // what an earlier run has written from here on is no longer true
            while (!history.curve.t.empty() && history.curve.t.back() >= from) {
                history.curve.t.pop_back();
                history.curve.y.pop_back();
            }
        for (const auto& row : rows.columns) {
            std::size_t k = 0;
            for (std::size_t c = 1; c < row.size(); ++c)
                for (const double y : row[c])
                    if (k < histories.size()) {
                        histories[k].curve.t.push_back(row[0][0]);
                        histories[k++].curve.y.push_back(y);
                    }
            for (; k < histories.size(); ++k) {  // a column that this run does not have
                histories[k].curve.t.push_back(row[0][0]);
                histories[k].curve.y.push_back(std::numeric_limits<double>::quiet_NaN());
            }
        }
    }
    if (histories.empty()) throw UserError(fmt::format("no rows in \"{}\"", (place / "*" / file).string()));
    return histories;
}

std::vector<std::string> historyFiles(const fs::path& root, const std::string& function) {
    std::set<std::string> files;
    for (const auto& start : startFolders(root, function))
        for (const auto& entry : fs::directory_iterator(root / "postProcessing" / function / start.name))
            if (entry.is_regular_file()) files.insert(entry.path().filename().string());
    if (files.empty())
        throw UserError(fmt::format("no tables in \"{}\"", (root / "postProcessing" / function).string()));
    return {files.begin(), files.end()};
}

}  // namespace pfem
