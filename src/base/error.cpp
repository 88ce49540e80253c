#include "base/error.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace pfem {

namespace {

int editDistance(const std::string& a, const std::string& b) {
    std::vector<int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        int diagonal = row[0];
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = std::tolower(static_cast<unsigned char>(a[i - 1])) ==
                              std::tolower(static_cast<unsigned char>(b[j - 1]));
            const int replaced = diagonal + (same ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}

}  // namespace

std::string nearestWord(const std::string& word, const std::vector<std::string>& valid) {
    std::string best;
    int bestDistance = std::max(2, static_cast<int>(word.size() + 2) / 3) + 1;
    for (const auto& candidate : valid) {
        const int distance = editDistance(word, candidate);
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string toString(const Location& where) {
    return where.line > 0 ? where.file + ":" + std::to_string(where.line) : where.file;
}

std::string notValid(const std::string& word, const std::string& what, const std::vector<std::string>& valid) {
    std::vector<std::string> sorted = valid;
    std::sort(sorted.begin(), sorted.end());
    std::string text = "Unknown " + what + " " + word;
    const std::string near = nearestWord(word, sorted);
    if (!near.empty()) text += " (did you mean '" + near + "'?)";
    text += "\n\nValid " + what +
            (what.ends_with("ch")  ? "es"
             : what.ends_with("s") ? ""
                                   : "s") +
            " :\n\n" + std::to_string(sorted.size()) + "\n(\n";
    for (const auto& w : sorted) text += w + "\n";
    return text + ")";
}

}  // namespace pfem
