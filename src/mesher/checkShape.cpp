#include <fmt/format.h>

#include <algorithm>

#include "mesher/checks.hpp"
#include "mesher/crossing.hpp"
#include "mesher/segmentDistance.hpp"
#include "mesher/thinOut.hpp"

namespace pfem {

namespace {

/// A straight edge of an outline, or a chord of an arc.
struct Side {
    Vec<2> a, b;
    int from, to;  // points of the outline; -1: within an arc
};

/// The sides of one outline that touch or cross.
class Shape {
public:
    Shape(const MeshDescription& mesh, int outline, bool arcs)
        : mesh_(mesh),
          index_(outline),
          outline_(outlineOf(mesh, outline)),
          wall_(outline >= static_cast<int>(mesh.bodies.size())),
          tolerance_(mergeDistance(mesh)),
          detail_(thinOutTolerance * 1e6 * tolerance_) {
        const auto points = distinctPoints(outline_, tolerance_);
        const int n = static_cast<int>(outline_.points.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
            if (k + 1 == points.size() && !outline_.closed) break;
            const int from = points[k], to = points[(k + 1) % points.size()];
            const Curve curve = edgeCurve(outline_, (to + n - 1) % n);  // those between are merged with `from`
            const int chords = curve.isArc() ? 32 : 1;
            if (curve.isArc() && !arcs) continue;
            for (int c = 0; c < chords; ++c)
                sides_.push_back({c == 0 ? outline_.points[from] : curve.point(double(c) / chords),
                                  curve.point(double(c + 1) / chords), c == 0 ? from : -1, c + 1 == chords ? to : -1});
        }
    }

    void check() const {
        for (std::size_t k = 0; k < sides_.size(); ++k) {
            const Side &s = sides_[k], &t = sides_[(k + 1) % sides_.size()];
            if (s.to >= 0 && s.to == t.from && &s != &t) checkTurn(s, t);
        }
        std::vector<const Side*> order;
        for (const Side& s : sides_) order.push_back(&s);
        const auto low = [](const Side* s) { return std::min(s->a.x(), s->b.x()); };
        std::sort(order.begin(), order.end(), [&](const Side* s, const Side* t) { return low(s) < low(t); });
        for (std::size_t i = 0; i < order.size(); ++i) {
            const double high = std::max(order[i]->a.x(), order[i]->b.x()) + tolerance_;
            for (std::size_t j = i + 1; j < order.size() && low(order[j]) <= high; ++j) checkPair(*order[i], *order[j]);
        }
    }

private:
    std::string title() const { return titleOf(mesh_, index_); }
    std::string word() const { return pointsWord(mesh_, index_); }
    std::string one() const { return wall_ ? "point" : "vertex"; }
    static std::string place(const Vec<2>& x) { return fmt::format("({:.9g} {:.9g})", x.x(), x.y()); }
    [[noreturn]] void fail(const std::string& text, int point) const {
        throw UserError("The outline of " + title() + " " + text, outline_.atPoint(point, word()));
    }

    /// The next side must not lie on this one.
    void checkTurn(const Side& s, const Side& t) const {
        if (segmentDistance(t.b, s.a, s.b) > tolerance_ && segmentDistance(s.a, t.a, t.b) > tolerance_) return;
        if (s.from >= 0 && s.from == t.to) return;  // two edges between two points, one of them an arc
        if (std::min((s.b - s.a).norm(), (t.b - t.a).norm()) < detail_) return;
        fail(fmt::format("runs back on itself at its {} {} {}: a spike without width. {}", one(), s.to, place(s.b),
                         wall_ ? "A wall needs a thickness." : "Leave it out."),
             s.to);
    }

    void checkPair(const Side& s, const Side& t) const {
        for (const int p : {s.from, s.to})
            for (const int q : {t.from, t.to})
                if (p >= 0 && (p == q || neighbours(p, q))) return;
        if (!wall_) checkTouch(s, t);
        if (const auto at = crossingOf(s.a, s.b, t.a, t.b); at && !(wall_ && touch(s, t)))
            fail(fmt::format("crosses itself near {}: {} and {}", place(*at), edge(s), edge(t)), std::max(s.from, 0));
    }

    /// Whether an edge too short for the mesh to show joins the points.
    bool neighbours(int p, int q) const {
        const int n = static_cast<int>(outline_.points.size()), between = std::abs(p - q);
        return q >= 0 && (between == 1 || (outline_.closed && between == n - 1)) &&
               (outline_.points[p] - outline_.points[q]).norm() < detail_;
    }

    bool touch(const Side& s, const Side& t) const {
        return segmentDistance(s.a, t.a, t.b) <= tolerance_ || segmentDistance(s.b, t.a, t.b) <= tolerance_ ||
               segmentDistance(t.a, s.a, s.b) <= tolerance_ || segmentDistance(t.b, s.a, s.b) <= tolerance_;
    }
    static std::string edge(const Side& s) {
        return s.from < 0 || s.to < 0 ? "an arc" : fmt::format("edge {}-{}", s.from, s.to);
    }

    void checkTouch(const Side& s, const Side& t) const {
        for (const int p : {s.from, s.to})
            for (const int q : {t.from, t.to})
                if (p >= 0 && q >= 0 && (outline_.points[p] - outline_.points[q]).norm() <= tolerance_)
                    fail(fmt::format("touches itself: its vertices {} and {} are one point {}. {}", std::min(p, q),
                                     std::max(p, q), place(outline_.points[p]), remedy()),
                         std::max(p, q));
        for (const auto& [side, other] : {std::pair(&s, &t), std::pair(&t, &s)})
            for (const int p : {side->from, side->to})
                if (p >= 0 && segmentDistance(outline_.points[p], other->a, other->b) <= tolerance_)
                    fail(fmt::format("touches itself: its vertex {} {} lies on {}. {}", p, place(outline_.points[p]),
                                     edge(*other), remedy()),
                         p);
    }
    static std::string remedy() {
        return "Make two bodies of it or, where it goes round a hole, write the hole as a body of its own in 'holes'.";
    }

    const MeshDescription& mesh_;
    int index_;
    const Outline& outline_;
    bool wall_;
    double tolerance_, detail_;  // [m]: below the first points are one, below the second they may be left out
    std::vector<Side> sides_;
};

}  // namespace

void checkShape(const MeshDescription& mesh, int outline, bool arcs) { Shape(mesh, outline, arcs).check(); }

}  // namespace pfem
