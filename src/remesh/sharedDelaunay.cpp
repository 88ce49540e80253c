#include "remesh/sharedDelaunay.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "base/parallel.hpp"
#include "remesh/openFaces.hpp"
#include "remesh/provenCells.hpp"
#include "remesh/spaceDelaunay.hpp"

namespace pfem {

namespace {

/// What is missing beside known cells.
class Completion {
public:
    Completion(const Points<3>& x, const std::vector<int>& active, Triangulation<3> known) : known_(std::move(known)) {
        findOpenFaces(x, PointBox(x, active));
        joinParts();
        rest_ = spaceDelaunay(x, openPoints(active, x.size()));
        beyond_.assign(rest_.cells.size(), {-1, -1, -1, -1});
        missing_.assign(rest_.cells.size(), 0);
    }

    /// Cells of the rest that are missing: on the far side of open faces, and all that is joined to them without
    /// crossing one: what fills a gap between known cells, or between them and the hull, meets one of them. Does each
    /// open face have its other side?
    bool findMissing() {
        const int n = static_cast<int>(rest_.cells.size());
        const auto closed = parallelSum(n, [&](int r) {
            std::size_t count = 0;
            for (int k = 0; k < 4; ++k) {
                const Face<3> face = outwardFace(rest_.cells[r], k);
                beyond_[r][k] = openFace(turnedRound(face));
                const bool atHull = rest_.neighbours[r][k] < 0;
                count += beyond_[r][k] >= 0 || (atHull && openFace(face) >= 0);
            }
            return count;
        });
        std::vector<int> work = parallelChosen(n, [&](int r) {
            missing_[r] = std::any_of(beyond_[r].begin(), beyond_[r].end(), [](int face) { return face >= 0; });
            return missing_[r] != 0;
        });
        const auto take = [&](int r) {
            if (!missing_[r]) work.push_back(r);
            missing_[r] = 1;
        };
        while (!work.empty()) {
            const int r = work.back();
            work.pop_back();
            for (int k = 0; k < 4; ++k)
                if (beyond_[r][k] < 0 && rest_.neighbours[r][k] >= 0) take(rest_.neighbours[r][k]);
        }
        return closed == open_.size();
    }

    /// Known and missing cells in one order.
    Triangulation<3> merged() const {
        const auto& cells = known_.cells;
        const auto& neighbours = known_.neighbours;
        std::vector<int> ofKnown(cells.size()), ofRest(rest_.cells.size(), -1), added;
        for (int r = 0; r < static_cast<int>(rest_.cells.size()); ++r)
            if (missing_[r]) added.push_back(r);
        const Merged merged(cells.begin(), static_cast<int>(cells.size()), static_cast<int>(added.size()),
                            [&](int r) { return rest_.cells[added[r]]; });
        Triangulation<3> result;
        result.cells.resize(cells.size() + added.size());
        result.neighbours.resize(result.cells.size());
        merged.place(
            [&](int own, int to) {
                ofKnown[own] = to;
                result.cells[to] = cells[own];
            },
            [&](int r, int to) {
                ofRest[added[r]] = to;
                result.cells[to] = rest_.cells[added[r]];
                result.neighbours[to] = {-1, -1, -1, -1};
            });
        parallelFor(static_cast<int>(cells.size()), [&](int own) {
            for (int k = 0; k < 4; ++k)
                result.neighbours[ofKnown[own]][k] = neighbours[own][k] < 0 ? -1 : ofKnown[neighbours[own][k]];
        });
        for (std::size_t r = 0; r < rest_.cells.size(); ++r)
            for (int k = 0; missing_[r] && k < 4; ++k) {
                if (beyond_[r][k] < 0) {
                    const int other = rest_.neighbours[r][k];
                    if (other >= 0) result.neighbours[ofRest[r]][k] = ofRest[other];
                    continue;
                }
                const OpenFace& open = open_[beyond_[r][k]];
                result.neighbours[ofRest[r]][k] = ofKnown[open.cell];
                result.neighbours[ofKnown[open.cell]][open.opposite] = ofRest[r];
            }
        return result;
    }

private:
    void findOpenFaces(const Points<3>& x, const PointBox& box) {
        open_ = openFaces(known_, x, box);
        std::sort(open_.begin(), open_.end(), [](const OpenFace& a, const OpenFace& b) { return a.face < b.face; });
    }

    /// Known cells on both sides of a face are neighbours: those of different parts, and of ranks all of them.
    void joinParts() {
        for (const OpenFace& open : open_) {
            const int other = openFace(turnedRound(open.face));
            if (other >= 0) known_.neighbours[open.cell][open.opposite] = open_[other].cell;
        }
        std::erase_if(open_, [&](const OpenFace& open) { return known_.neighbours[open.cell][open.opposite] >= 0; });
    }

    /// Those of open faces, and those without a known cell: a star has no other way from known to missing cells than
    /// through an open face.
    std::vector<int> openPoints(const std::vector<int>& active, std::size_t nPoints) const {
        std::vector<unsigned char> isOpen(nPoints, 1);
        parallelFor(static_cast<int>(known_.cells.size()), [&](int e) {
            for (const int i : known_.cells[e])
                std::atomic_ref(isOpen[i]).store(0, std::memory_order_relaxed);  // threads meet at nodes
        });
        for (const auto& open : open_)
            for (const int i : open.face) isOpen[i] = 1;
        std::vector<int> points;
        for (const int i : active)
            if (isOpen[i]) points.push_back(i);
        return points;
    }

    /// The number of the open face with these nodes in this order, or -1.
    int openFace(const Face<3>& face) const {
        const auto at = std::lower_bound(open_.begin(), open_.end(), face,
                                         [](const OpenFace& open, const Face<3>& f) { return open.face < f; });
        return at != open_.end() && at->face == face ? static_cast<int>(at - open_.begin()) : -1;
    }

    Triangulation<3> known_;
    std::vector<OpenFace> open_;
    Triangulation<3> rest_;                   // of the open points
    std::vector<std::array<int, 4>> beyond_;  // per face of the rest: the open face whose other side it is, or -1
    std::vector<unsigned char> missing_;      // per cell of the rest
};

/// Parts of one order each, one after the other, to one order.
template <class Value>
void mergeParts(std::vector<Value>& all, const std::vector<std::size_t>& ends) {
    const auto at = [&](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    for (std::size_t part = 1; part < ends.size(); ++part)
        std::inplace_merge(all.begin(), at(ends[part - 1]), at(ends[part]));
}

/// Cells of all parts, each of which has all with the first nodes that are its own.
Triangulation<3> inOneOrder(const std::vector<ProvenCells>& parts, std::size_t nPoints) {
    std::vector<int> start(nPoints + 1, 0);  // of the cells with each first node
    for (const auto& part : parts)
        for (const auto& cell : part.cells) ++start[cell[0] + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    Triangulation<3> all;
    all.cells.resize(start[nPoints]);
    all.neighbours.resize(start[nPoints]);
    parallelTasks(static_cast<int>(parts.size()), [&](int p) {
        const auto& [cells, neighbours] = static_cast<const Triangulation<3>&>(parts[p]);
        std::vector<int> number(cells.size());
        for (std::size_t e = 0; e < cells.size(); ++e)
            number[e] = e > 0 && cells[e - 1][0] == cells[e][0] ? number[e - 1] + 1 : start[cells[e][0]];
        for (std::size_t e = 0; e < cells.size(); ++e) {
            all.cells[number[e]] = cells[e];
            for (int k = 0; k < 4; ++k)
                all.neighbours[number[e]][k] = neighbours[e][k] < 0 ? -1 : number[neighbours[e][k]];
        }
    });
    return all;
}

}  // namespace

std::optional<Triangulation<3>> completed(const Points<3>& x, const std::vector<int>& active, Triangulation<3> known) {
    if (known.cells.empty()) return spaceDelaunay(x, active);
    Completion completion(x, active, std::move(known));
    if (!completion.findMissing()) return std::nullopt;
    return completion.merged();
}

Triangulation<3> sharedDelaunay(const Points<3>& x, const std::vector<int>& active, const Ranks& ranks, double halo) {
    const auto parts = bisect<3>(x, active, ranks.size());
    const ProvenCells mine = provenCells(x, active, parts, ranks.rank(), halo);
    std::vector<std::size_t> ends;
    std::vector<Simplex<3>> known = ranks.gather(std::vector(mine.cells.begin(), mine.cells.end()), ends);
    const auto coincide = ranks.gather(std::vector<unsigned char>{mine.coincide});
    if (std::count(coincide.begin(), coincide.end(), 1) == 0) {
        mergeParts(known, ends);
        Triangulation<3> ofAll{{known.begin(), known.end()}, {}};
        ofAll.neighbours.assign(known.size(), {-1, -1, -1, -1});  // unknown
        if (auto whole = completed(x, active, std::move(ofAll))) return *std::move(whole);
    }
    return spaceDelaunay(x, active);  // of points that coincide one stands for all: which one, only the whole can say
}

std::optional<Triangulation<3>> threadedDelaunay(const Points<3>& x, const std::vector<int>& active, int nThreads,
                                                 double halo) {
    const auto parts = bisect<3>(x, active, nThreads);
    std::vector<ProvenCells> proven(nThreads);
    parallelTasks(nThreads, [&](int part) { proven[part] = provenCells(x, active, parts, part, halo); });
    if (std::any_of(proven.begin(), proven.end(), [](const ProvenCells& part) { return part.coincide; }))
        return std::nullopt;
    return completed(x, active, inOneOrder(proven, x.size()));
}

}  // namespace pfem
