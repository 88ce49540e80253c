#include "mesher/mshGroups.hpp"

#include <array>
#include <cstdlib>

namespace pfem {

namespace {

/// How many points, curves and surfaces follow, and volumes, which a mesh of the plane may have but does not use.
std::array<long, 4> counts(MshLines& lines, const char* section) {
    lines.demand(section, 4);
    return {lines.count(0), lines.count(1), lines.count(2), lines.count(3)};
}

/// The list whose length is word `at`: the words after it.
std::vector<long> list(const MshLines& lines, std::size_t at) {
    lines.need(at + 1);
    const auto n = static_cast<std::size_t>(lines.count(at));
    lines.need(at + 1 + n);
    std::vector<long> values;
    for (std::size_t k = 0; k < n; ++k) values.push_back(lines.whole(at + 1 + k));
    return values;
}

std::vector<long> withoutSigns(std::vector<long> tags) {
    for (long& tag : tags) tag = std::abs(tag);
    return tags;
}

constexpr std::size_t wordsOfPlace(int dimension) { return dimension == 0 ? 3 : 6; }  // a point, or a box

}  // namespace

void MshGroups::readNames(MshLines& lines) {
    lines.demand("PhysicalNames", 1);
    for (long n = lines.count(0); n > 0; --n) {
        lines.demand("PhysicalNames", 3);
        const auto begin = lines.text().find('"'), end = lines.text().rfind('"');
        if (begin == std::string::npos || end <= begin) lines.fail("a name in quotes expected");
        names_[{static_cast<int>(lines.whole(0)), lines.whole(1)}] = lines.text().substr(begin + 1, end - begin - 1);
    }
}

void MshGroups::readEntities(MshLines& lines) {
    const auto n = counts(lines, "Entities");
    for (int dimension = 0; dimension < 4; ++dimension)
        for (long k = 0; k < n[dimension]; ++k) {
            lines.demand("Entities", 2 + wordsOfPlace(dimension));
            ofEntity_[{dimension, lines.whole(0)}] = withoutSigns(list(lines, 1 + wordsOfPlace(dimension)));
        }
}

void MshGroups::readPartitionedEntities(MshLines& lines) {
    lines.demand("PartitionedEntities", 1);  // how many parts
    lines.demand("PartitionedEntities", 1);
    for (long ghosts = lines.count(0); ghosts > 0; --ghosts) lines.demand("PartitionedEntities", 2);
    const auto n = counts(lines, "PartitionedEntities");
    for (int dimension = 0; dimension < 4; ++dimension)
        for (long k = 0; k < n[dimension]; ++k) {
            lines.demand("PartitionedEntities", 4);
            const long parentDimension = lines.whole(1), parent = lines.whole(2);
            const std::size_t nParts = list(lines, 3).size();
            auto groups = withoutSigns(list(lines, 4 + nParts + wordsOfPlace(dimension)));
            if (parentDimension != dimension)
                groups.clear();  // a cut between parts: the groups are those of what it cuts
            else if (groups.empty())
                groups = of(dimension, parent);
            ofEntity_[{dimension, lines.whole(0)}] = groups;
        }
}

const std::vector<long>& MshGroups::of(int dimension, long entity) const {
    static const std::vector<long> none;
    const auto found = ofEntity_.find({dimension, entity});
    return found == ofEntity_.end() ? none : found->second;
}

std::string MshGroups::name(int dimension, long tag) const {
    const auto named = names_.find({dimension, tag});
    return named != names_.end() ? named->second : std::to_string(tag);
}

}  // namespace pfem
