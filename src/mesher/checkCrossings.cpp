#include <optional>

#include "mesh/bins.hpp"
#include "mesher/checks.hpp"
#include "mesher/chords.hpp"
#include "mesher/crossing.hpp"

namespace pfem {

namespace {

/// The first two chords that cross, and where.
struct Crossing {
    int piece, other;
    Vec<2> at;
};

std::optional<Crossing> findCrossing(const Chords& chords, const Points<2>& x) {
    Bins<2> bins(x, chords.longest);
    std::optional<Crossing> found;
    for (int k = 0; k < static_cast<int>(chords.all.size()) && !found; ++k) {
        const Chord& c = chords.all[k];
        const Vec<2> low = x[c.a].cwiseMin(x[c.b]), high = x[c.a].cwiseMax(x[c.b]);
        bins.any(low, high, [&](int other) {
            const Chord& d = chords.all[other];
            if (d.touches(c.a) || d.touches(c.b)) return false;
            if (const auto at = crossingOf(x[c.a], x[c.b], x[d.a], x[d.b])) found = Crossing{d.piece, c.piece, *at};
            return found.has_value();
        });
        bins.add(k, low, high);
    }
    return found;
}

}  // namespace

void checkCrossings(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary) {
    const Names names(mesh, arrangement);
    const auto crossing = findCrossing(Chords(boundary), boundary.x);
    if (!crossing) return;
    const auto& [p, q, at] = *crossing;
    const std::string where = fmt::format("near ({:.6g} {:.6g})", at.x(), at.y());
    if (names.sameOutline(p, q))
        throw UserError(fmt::format("The outline of {} crosses itself {}: {} and {}", names.title(p), where,
                                    names.edge(p), names.edge(q)),
                        names.place(p));
    throw UserError(
        fmt::format(
            "The outlines of {} ({}) and {} ({}) cross {}: bodies must not overlap, and a wall must not cut a body",
            names.title(p), names.edge(p), names.title(q), names.edge(q), where),
        names.place(std::max(p, q)));
}

bool crosses(const BoundaryNodes& boundary) { return findCrossing(Chords(boundary), boundary.x).has_value(); }

}  // namespace pfem
