#include <fmt/format.h>

#include <algorithm>

#include "mesher/binGrid.hpp"
#include "mesher/checks.hpp"
#include "mesher/crossing.hpp"

namespace pfem {

namespace {

constexpr double leastGap = 0.1;     // between outlines that do not touch / mesh size
constexpr double leastAngle = 0.05;  // between edges that meet: its sine

struct Chord {
    int a, b;
    int piece;
    bool touches(int node) const { return a == node || b == node; }
    int otherEnd(int node) const { return a == node ? b : a; }
};

/// The chords of the divided outlines, and which of them end at each node.
struct Chords {
    std::vector<Chord> all;
    std::vector<std::vector<int>> at;
    double longest = 0;

    explicit Chords(const BoundaryNodes& boundary) : at(boundary.x.size()) {
        for (std::size_t p = 0; p < boundary.ofPiece.size(); ++p) {
            const auto& chain = boundary.ofPiece[p];
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
                for (const int node : {chain[i], chain[i + 1]}) at[node].push_back(static_cast<int>(all.size()));
                all.push_back({chain[i], chain[i + 1], static_cast<int>(p)});
                longest = std::max(longest, (boundary.x[chain[i]] - boundary.x[chain[i + 1]]).norm());
            }
        }
    }
};

/// The first two chords that cross, and where.
struct Crossing {
    int piece, other;
    Vec<2> at;
};

std::optional<Crossing> findCrossing(const Chords& chords, const Points<2>& x) {
    BinGrid bins(chords.longest);
    std::optional<Crossing> found;
    for (int k = 0; k < static_cast<int>(chords.all.size()) && !found; ++k) {
        const Chord& c = chords.all[k];
        bins.forEach(x[c.a].cwiseMin(x[c.b]), x[c.a].cwiseMax(x[c.b]), [&](int other) {
            const Chord& d = chords.all[other];
            if (found || d.touches(c.a) || d.touches(c.b)) return;
            if (const auto at = crossingOf(x[c.a], x[c.b], x[d.a], x[d.b])) found = Crossing{d.piece, c.piece, *at};
        });
        bins.addSegment(k, x[c.a], x[c.b]);
    }
    return found;
}

/// What messages call the boundary's pieces.
class Names {
public:
    Names(const MeshDescription& mesh, const Arrangement& arrangement) : mesh_(mesh), arrangement_(arrangement) {}

    bool sameOutline(int p, int q) const { return use(p).outline == use(q).outline; }
    std::string title(int piece) const { return titleOf(mesh_, use(piece).outline); }
    /// "edge 2-3": the points of the outline that it joins.
    std::string edge(int piece) const {
        const int from = use(piece).edge, n = static_cast<int>(outline(piece).points.size());
        return fmt::format("edge {}-{}", from, (from + 1) % n);
    }
    Location place(int piece) const {
        return outline(piece).atPoint(use(piece).edge, pointsWord(mesh_, use(piece).outline));
    }
    /// "vertex 3 (0.1 0)": the piece's outline has it next to x.
    std::string point(int piece, const Vec<2>& x) const {
        const auto& points = outline(piece).points;
        const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vec<2>& p, const Vec<2>& q) {
            return (p - x).squaredNorm() < (q - x).squaredNorm();
        });
        return fmt::format("{} {} ({:.9g} {:.9g})", arrangement_.isWall(use(piece)) ? "point" : "vertex", nearest - points.begin(), x.x(), x.y());
    }

private:
    /// That of an outline itself, not of one that has it as a hole.
    const PieceUse& use(int piece) const { return arrangement_.pieces[piece].uses.front(); }
    const Outline& outline(int piece) const { return outlineOf(mesh_, use(piece).outline); }

    const MeshDescription& mesh_;
    const Arrangement& arrangement_;
};

void checkCrossings(const Names& names, const Chords& chords, const Points<2>& x) {
    const auto crossing = findCrossing(chords, x);
    if (!crossing) return;
    const auto& [p, q, at] = *crossing;
    const std::string where = fmt::format("near ({:.6g} {:.6g})", at.x(), at.y());
    if (names.sameOutline(p, q))
        throw UserError(fmt::format("The outline of {} crosses itself {}: {} and {}", names.title(p), where, names.edge(p), names.edge(q)),
                        names.place(p));
    throw UserError(fmt::format("The outlines of {} ({}) and {} ({}) cross {}: bodies must not overlap, and a wall must not cut a body",
                                names.title(p), names.edge(p), names.title(q), names.edge(q), where),
                    names.place(std::max(p, q)));
}

/// The nodes that one comes to from a node along the outlines without leaving the circle of some radius: what they bound is
/// a detail, not a gap. Also the next ones, wherever they are.
class Neighbourhood {
public:
    Neighbourhood(const Chords& chords, const Points<2>& x) : chords_(chords), x_(x), seenFrom_(x.size(), -1) {}

    void find(int node, double radius) {
        seenFrom_[node] = node;
        std::vector<int> reached = {node};
        for (std::size_t k = 0; k < reached.size(); ++k)
            for (const int c : chords_.at[reached[k]]) {
                const int next = chords_.all[c].otherEnd(reached[k]);
                if (seenFrom_[next] == node) continue;
                const bool within = (x_[next] - x_[node]).norm() <= radius;
                if (within) reached.push_back(next);
                if (within || k == 0) seenFrom_[next] = node;
            }
        node_ = node;
    }
    bool has(const Chord& chord) const { return seenFrom_[chord.a] == node_ || seenFrom_[chord.b] == node_; }

private:
    const Chords& chords_;
    const Points<2>& x_;
    std::vector<int> seenFrom_;
    int node_ = -1;
};

void checkGaps(const Names& names, const Chords& chords, const BoundaryNodes& boundary) {
    const auto& x = boundary.x;
    double widest = chords.longest;
    for (const double size : boundary.h) widest = std::max(widest, leastGap * size);
    BinGrid bins(widest);
    for (int k = 0; k < static_cast<int>(chords.all.size()); ++k) bins.addSegment(k, x[chords.all[k].a], x[chords.all[k].b]);
    Neighbourhood joined(chords, x);
    for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        const double least = leastGap * boundary.h[i];
        joined.find(i, 1.5 * least);
        bins.forEachNear(x[i], least, [&](int k) {
            const Chord& c = chords.all[k];
            if (joined.has(c)) return;
            const double distance = segmentDistance(x[i], x[c.a], x[c.b]);
            if (distance >= least) return;
            const auto& near = chords.at[i];
            const int mine = chords.all[near.back()].piece;
            if (names.sameOutline(mine, c.piece))
                throw UserError(fmt::format("The outline of {} comes within {:.3g} of itself at ({:.9g} {:.9g}), {} and {}: too narrow for its "
                                            "meshSize {:g}.\nLeave at least a tenth of meshSize between them, or choose a smaller one.",
                                            names.title(mine), distance, x[i].x(), x[i].y(), names.edge(mine), names.edge(c.piece),
                                            boundary.h[i]),
                                names.place(mine));
            throw UserError(fmt::format("The point ({:.9g} {:.9g}) of {} ({}) is {:.3g} from {} ({}): neither joined nor apart "
                                        "(meshSize {:g}).\nGive both the same coordinates, or leave at least a tenth of "
                                        "meshSize between them.",
                                        x[i].x(), x[i].y(), names.title(mine), names.edge(mine), distance, names.title(c.piece),
                                        names.edge(c.piece), boundary.h[i]),
                            names.place(std::max(mine, c.piece)));
        });
    }
}

}  // namespace

void checkBoundary(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary) {
    const Names names(mesh, arrangement);
    const Chords chords(boundary);
    checkCrossings(names, chords, boundary.x);
    checkGaps(names, chords, boundary);
}

bool crosses(const BoundaryNodes& boundary) { return findCrossing(Chords(boundary), boundary.x).has_value(); }

void checkSpikes(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary) {
    const Names names(mesh, arrangement);
    const Chords chords(boundary);
    const auto& x = boundary.x;
    for (int i = 0; i < static_cast<int>(x.size()); ++i)
        for (const int k : chords.at[i])
            for (const int l : chords.at[i]) {
                if (k >= l) continue;
                const Vec<2> u = x[chords.all[k].otherEnd(i)] - x[i], v = x[chords.all[l].otherEnd(i)] - x[i];
                const double sine = std::abs(u.x() * v.y() - u.y() * v.x()) / (u.norm() * v.norm());
                if (u.dot(v) <= 0 || sine >= leastAngle) continue;
                const int p = chords.all[k].piece, q = chords.all[l].piece;
                const double degrees = std::asin(sine) * 180 / M_PI;
                if (names.sameOutline(p, q))
                    throw UserError(fmt::format("The outline of {} has a spike of {:.2g} degrees at its {}: too sharp for a triangle. "
                                                "Leave it out or make it wider.",
                                                names.title(p), degrees, names.point(p, x[i])),
                                    names.place(p));
                throw UserError(fmt::format("{} ({}) and {} ({}) meet at ({:.9g} {:.9g}) at an angle of {:.2g} degrees: too sharp for a triangle",
                                            names.title(p), names.edge(p), names.title(q), names.edge(q), x[i].x(), x[i].y(), degrees),
                                names.place(std::max(p, q)));
            }
}

}  // namespace pfem
