#include "mesh/bins.hpp"
#include "mesher/checks.hpp"
#include "mesher/chords.hpp"
#include "mesher/segmentDistance.hpp"

namespace pfem {

namespace {

constexpr double leastGap = 0.1;  // between outlines that do not touch / mesh size

/// The nodes that one comes to from a node along the outlines without leaving the circle of some radius: what they
/// bound is a detail, not a gap. Also the next ones, wherever they are.
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

}  // namespace

void checkGaps(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary) {
    const Names names(mesh, arrangement);
    const Chords chords(boundary);
    const auto& x = boundary.x;
    double widest = chords.longest;
    for (const double size : boundary.h) widest = std::max(widest, leastGap * size);
    Bins<2> bins(x, widest);
    for (int k = 0; k < static_cast<int>(chords.all.size()); ++k)
        bins.add(k, x[chords.all[k].a].cwiseMin(x[chords.all[k].b]), x[chords.all[k].a].cwiseMax(x[chords.all[k].b]));
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
                throw UserError(
                    fmt::format(
                        "The outline of {} comes within {:.3g} of itself at ({:.9g} {:.9g}), {} and {}: too narrow for "
                        "its "
                        "meshSize {:g}.\nLeave at least a tenth of meshSize between them, or choose a smaller one.",
                        names.title(mine), distance, x[i].x(), x[i].y(), names.edge(mine), names.edge(c.piece),
                        boundary.h[i]),
                    names.place(mine));
            throw UserError(
                fmt::format("The point ({:.9g} {:.9g}) of {} ({}) is {:.3g} from {} ({}): neither joined nor apart "
                            "(meshSize {:g}).\nGive both the same coordinates, or leave at least a tenth of "
                            "meshSize between them.",
                            x[i].x(), x[i].y(), names.title(mine), names.edge(mine), distance, names.title(c.piece),
                            names.edge(c.piece), boundary.h[i]),
                names.place(std::max(mine, c.piece)));
        });
    }
}

}  // namespace pfem
