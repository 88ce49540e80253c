#include <fmt/format.h>

#include <algorithm>

#include "mesher/checks.hpp"
#include "mesher/thinOut.hpp"

namespace pfem {

namespace {

constexpr std::size_t mostNamed = 5;  // of many alike

int nOutlines(const MeshDescription& mesh) { return static_cast<int>(mesh.bodies.size() + mesh.walls.size()); }

std::string placeText(const Location& where) {
    return where.file.empty() ? "" : fmt::format(" ({}:{})", where.file, where.line);
}

}  // namespace

std::vector<std::string> mergedPoints(const MeshDescription& mesh, double tolerance) {
    std::vector<std::string> texts;
    for (int o = 0; o < nOutlines(mesh); ++o) {
        const Outline& outline = outlineOf(mesh, o);
        const auto distinct = distinctPoints(outline, tolerance);
        const auto word = pointsWord(mesh, o);
        std::vector<std::string> pairs;
        Location first;
        for (int i = 0; i < static_cast<int>(outline.points.size()); ++i) {
            if (std::binary_search(distinct.begin(), distinct.end(), i)) continue;
            const auto before = std::lower_bound(distinct.begin(), distinct.end(), i);
            const int with =
                i > distinct.back()
                    ? (outline.points[i] - outline.points[distinct.back()]).norm() <= tolerance ? distinct.back() : 0
                    : *(before - 1);
            if (pairs.empty()) first = outline.atPoint(i, word);
            pairs.push_back(
                fmt::format("{} and {} ({:.2g} m apart)", with, i, (outline.points[i] - outline.points[with]).norm()));
        }
        if (pairs.empty()) continue;
        const std::size_t n = pairs.size();
        pairs.resize(std::min(n, mostNamed));
        texts.push_back(fmt::format("{} {}{} of {} are one point: merged{}", word, fmt::join(pairs, ", "),
                                    n > mostNamed ? fmt::format(" and {} more pairs", n - mostNamed) : "",
                                    titleOf(mesh, o), placeText(first)));
    }
    return texts;
}

std::vector<std::string> leftOutPoints(const MeshDescription& mesh, const Arrangement& whole,
                                       const std::vector<int>& leftOut) {
    std::vector<std::string> texts;
    for (int o = 0; o < nOutlines(mesh); ++o) {
        if (leftOut[o] == 0) continue;
        const Outline& outline = outlineOf(mesh, o);
        const auto n = whole.chains[o].size() + static_cast<std::size_t>(whole.spikes[o]) + (outline.closed ? 0 : 1);
        texts.push_back(
            fmt::format("the outline of {} has more points than the mesh size can show: {} of {} are left out, and it "
                        "changes by less "
                        "than {:g} of that size{}",
                        titleOf(mesh, o), leftOut[o], n, thinOutTolerance, placeText(outline.at(pointsWord(mesh, o)))));
    }
    return texts;
}

}  // namespace pfem
