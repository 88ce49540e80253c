#pragma once
// A tree of boxes over the triangles of several surfaces: what does a segment meet, what is nearest to a point?

#include <functional>

#include "base/types.hpp"

namespace pfem {

class BoxTree {
public:
    using Triangle = std::array<Vec<3>, 3>;
    explicit BoxTree(std::vector<Triangle> triangles);

    const Triangle& triangle(int k) const { return triangles_[k]; }

    /// f(triangle, t) for all that the segment a + t (b - a) meets; inclusive: what touches counts.
    void forEachMet(const Vec<3>& a, const Vec<3>& b, const std::function<void(int, double)>& f) const;

    /// f(triangle) for all whose boxes touch this one.
    void forEachIn(const Vec<3>& low, const Vec<3>& high, const std::function<void(int)>& f) const;

    /// Distance of x from the nearest triangle, or `most` when none is nearer [m]; its number.
    std::pair<double, int> nearest(const Vec<3>& x, double most) const;

private:
    struct Node {
        Vec<3> low, high;
        int first, last;  // of a leaf: its items in order_
        int left = -1, right = -1;
    };
    int build(int first, int last);

    std::vector<Triangle> triangles_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

}  // namespace pfem
