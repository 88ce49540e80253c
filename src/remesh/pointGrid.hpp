#pragma once
// Points in the order of the boxes of a grid: those near a place lie together in memory, which Bins (mesh/bins.hpp),
// for things that have a size, do not promise. Each ball of a triangulation is asked in each step.

#include <algorithm>
#include <array>
#include <vector>

#include "remesh/enclosingBall.hpp"
#include "remesh/pointBox.hpp"

namespace pfem {

class PointGrid {
public:
    struct Place {
        Vec<3> x;
        int number;
    };

    /// The points that `active` names, which fill `whole`, in boxes of this width [m], or of a larger one where there
    /// would be many more boxes than points.
    PointGrid(const Points<3>& x, const std::vector<int>& active, const PointBox& whole, double width);

    /// f(place) for the points in the ball, until it gives true. Was there a true?
    template <class F>
    bool any(const Ball& ball, const F& f) const {
        const double squared = ball.radius * ball.radius * (1 + 1e-15), reach = ball.radius * (1 + 1e-9);
        const auto from = boxOf(ball.centre.array() - reach), to = boxOf(ball.centre.array() + reach);
        for (int i = from[0]; i <= to[0]; ++i)
            for (int j = from[1]; j <= to[1]; ++j) {
                const int last = start_[number({i, j, to[2]}) + 1];
                for (int p = start_[number({i, j, from[2]})]; p < last; ++p)
                    if ((places_[p].x - ball.centre).squaredNorm() <= squared && f(places_[p])) return true;
            }
        return false;
    }

    /// No point is in the ball but those of the cell.
    bool holdsNoOther(const Ball& ball, const Simplex<3>& cell) const {
        return !any(ball, [&](const Place& p) {
            return p.number != cell[0] && p.number != cell[1] && p.number != cell[2] && p.number != cell[3];
        });
    }

    /// Are two points at one place?
    bool coincide() const;

private:
    using Box = std::array<int, 3>;

    Box boxOf(const Vec<3>& x) const {
        Box box;
        for (int d = 0; d < 3; ++d)
            box[d] = static_cast<int>(std::clamp((x[d] - low_[d]) * boxesPerLength_, 0.0, count_[d] - 1.0));
        return box;
    }
    int number(const Box& box) const { return (box[0] * count_[1] + box[1]) * count_[2] + box[2]; }

    Vec<3> low_;
    double boxesPerLength_ = 1;  // [1/m]
    Box count_{1, 1, 1};
    std::vector<int> start_;  // per box
    std::vector<Place> places_;
};

}  // namespace pfem
