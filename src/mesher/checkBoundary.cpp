#include <fmt/format.h>

#include <algorithm>

#include "mesher/binGrid.hpp"
#include "mesher/checks.hpp"

namespace pfem {

namespace {

struct Chord {
    int a, b;
    int piece;
};

std::string owner(const MeshDescription& mesh, const Arrangement& arrangement, int piece) {
    const int outline = arrangement.pieces[piece].uses.front().outline;
    const bool wall = outline >= arrangement.nBodies;
    return fmt::format("{} '{}'", wall ? "wall" : "body", outlineOf(mesh, outline).name);
}

Location place(const MeshDescription& mesh, const Arrangement& arrangement, int piece) {
    const int outline = arrangement.pieces[piece].uses.front().outline;
    return outlineOf(mesh, outline).at(outline < arrangement.nBodies ? "vertices" : "points");
}

double turn(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool cross(const Points<2>& x, const Chord& c, const Chord& d) {
    return (turn(x[c.a], x[c.b], x[d.a]) > 0) != (turn(x[c.a], x[c.b], x[d.b]) > 0) &&
           (turn(x[d.a], x[d.b], x[c.a]) > 0) != (turn(x[d.a], x[d.b], x[c.b]) > 0);
}

[[noreturn]] void throwCrossing(const MeshDescription& mesh, const Arrangement& arrangement, const Vec<2>& at,
                                int p, int q) {
    const auto first = owner(mesh, arrangement, p), second = owner(mesh, arrangement, q);
    const std::string where = fmt::format("near ({:.6g} {:.6g})", at.x(), at.y());
    if (first == second)
        throw UserError(fmt::format("The outline of {} crosses itself {}", first, where),
                        place(mesh, arrangement, p));
    throw UserError(
        fmt::format("The outlines of {} and {} cross {}: bodies must not overlap, and a wall must "
                    "not cut a body",
                    first, second, where),
        place(mesh, arrangement, std::max(p, q)));
}

}  // namespace

void checkBoundary(const MeshDescription& mesh, const Arrangement& arrangement,
                   const BoundaryNodes& boundary) {
    const auto& x = boundary.x;
    std::vector<Chord> chords;
    std::vector<std::vector<int>> around(x.size());  // neighbours of each node along the outlines
    double longest = 0;
    for (std::size_t p = 0; p < boundary.ofPiece.size(); ++p) {
        const auto& chain = boundary.ofPiece[p];
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            chords.push_back({chain[i], chain[i + 1], static_cast<int>(p)});
            around[chain[i]].push_back(chain[i + 1]);
            around[chain[i + 1]].push_back(chain[i]);
            longest = std::max(longest, (x[chain[i]] - x[chain[i + 1]]).norm());
        }
    }
    BinGrid bins(longest);
    const auto touches = [](const Chord& c, int node) { return c.a == node || c.b == node; };
    for (int k = 0; k < static_cast<int>(chords.size()); ++k) {
        const Chord& c = chords[k];
        bins.forEach(x[c.a].cwiseMin(x[c.b]), x[c.a].cwiseMax(x[c.b]), [&](int other) {
            const Chord& d = chords[other];
            if (touches(d, c.a) || touches(d, c.b) || !cross(x, c, d)) return;
            throwCrossing(mesh, arrangement, 0.5 * (x[c.a] + x[c.b]), d.piece, c.piece);
        });
        bins.addSegment(k, x[c.a], x[c.b]);
    }
    for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        const double least = 0.1 * boundary.h[i];
        bins.forEachNear(x[i], least, [&](int k) {
            const Chord& c = chords[k];
            const double distance = segmentDistance(x[i], x[c.a], x[c.b]);
            if (touches(c, i) || distance >= least) return;
            const auto& near = around[i];
            if (std::any_of(near.begin(), near.end(), [&](int j) { return touches(c, j); })) return;
            int mine = 0;  // a piece of node i
            for (const auto& own : chords)
                if (touches(own, i)) mine = own.piece;
            throw UserError(
                fmt::format("The point ({:.9g} {:.9g}) of {} is {:.3g} from {}: neither joined nor apart "
                            "(meshSize {:g}).\nGive both the same coordinates, or leave at least a tenth of "
                            "meshSize between them.",
                            x[i].x(), x[i].y(), owner(mesh, arrangement, mine), distance,
                            owner(mesh, arrangement, c.piece), boundary.h[i]),
                place(mesh, arrangement, std::max(mine, c.piece)));
        });
    }
}

}  // namespace pfem
