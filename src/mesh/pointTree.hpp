#pragma once
// Points in a tree of boxes: what lies in a box, however uneven the points are spread.

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// A k-d tree: each box holds its points' bounds and is halved across its longest side, so that both halves have as
/// many points, until few are left.
template <int Dim>
class PointTree {
public:
    explicit PointTree(const Points<Dim>& points) : order_(points.size()), x_(points) {
        std::iota(order_.begin(), order_.end(), 0);
        while ((order_.size() >> depth_) > most) ++depth_;
        boxes_.resize((std::size_t(2) << depth_) - 1);
        if (!points.empty()) build(points, whole());
        for (std::size_t k = 0; k < order_.size(); ++k) x_[k] = points[order_[k]];
    }

    /// f(number) for each point in the box from `low` to `high`, rim included.
    template <class F>
    void forEachIn(const Vec<Dim>& low, const Vec<Dim>& high, F&& f) const {
        if (!order_.empty()) visit(low, high, whole(), f);
    }

private:
    static constexpr std::size_t most = 8;  // points of a box that is not halved

    struct Box {
        Vec<Dim> low, high;
    };

    /// Points of order_ from `begin` to `end` in a box, to be halved `levels` times.
    struct Part {
        std::size_t box, begin, end;
        int levels;

        Part lower() const { return {2 * box + 1, begin, begin + (end - begin) / 2, levels - 1}; }
        Part upper() const { return {2 * box + 2, begin + (end - begin) / 2, end, levels - 1}; }
    };
    Part whole() const { return {0, 0, order_.size(), depth_}; }

    void build(const Points<Dim>& points, const Part& part) {
        Box& box = boxes_[part.box];
        box.low = box.high = points[order_[part.begin]];
        for (std::size_t p = part.begin; p < part.end; ++p) {
            box.low = box.low.cwiseMin(points[order_[p]]);
            box.high = box.high.cwiseMax(points[order_[p]]);
        }
        if (part.levels == 0) return;
        int axis = 0;
        (box.high - box.low).maxCoeff(&axis);
        const auto at = [&](std::size_t p) { return order_.begin() + static_cast<std::ptrdiff_t>(p); };
        std::nth_element(at(part.begin), at(part.lower().end), at(part.end),
                         [&](int a, int b) { return points[a][axis] < points[b][axis]; });
        build(points, part.lower());
        build(points, part.upper());
    }

    template <class F>
    void visit(const Vec<Dim>& low, const Vec<Dim>& high, const Part& part, F& f) const {
        const Box& box = boxes_[part.box];
        if ((box.low.array() > high.array()).any() || (box.high.array() < low.array()).any()) return;
        if (part.levels > 0) {
            visit(low, high, part.lower(), f);
            visit(low, high, part.upper(), f);
            return;
        }
        for (std::size_t p = part.begin; p < part.end; ++p)
            if ((x_[p].array() >= low.array()).all() && (x_[p].array() <= high.array()).all()) f(order_[p]);
    }

    int depth_ = 0;  // how often the whole is halved
    std::vector<int> order_;
    Points<Dim> x_;  // in that order
    std::vector<Box> boxes_;
};

}  // namespace pfem
