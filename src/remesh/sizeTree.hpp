#pragma once
// Many faces of wanted mesh sizes that grow away from them: how large may it be at a point? A tree of boxes.

#include "state/placeSizes.hpp"

namespace pfem {

template <int Dim>
class SizeTree {
public:
    /// To be called for all faces before the first question. `reach`: how far from it the size holds.
    void add(const typename SizePlace<Dim>::Corners& corners, double size, double reach);
    void build();

    /// Least of size + sizeGrowth max(0, distance - reach) over all faces, `most` where none is less.
    double at(const Vec<Dim>& x, double most) const;

private:
    struct Item {
        Face<Dim> corners;
        double size, reach;
    };
    struct Box {
        Vec<Dim> low, high;
        double size, offset;  // the least ones of its items: size, and size - sizeGrowth reach
        int first, last;      // of a leaf: its items
        int left = -1, right = -1;

        /// No item of the box gives less at x.
        double bound(const Vec<Dim>& x) const {
            return std::max(size, offset + sizeGrowth * distanceToBox<Dim>(x, low, high));
        }
    };
    int build(int first, int last);
    Box boxOf(int first, int last) const;
    double sizeAt(const Item& item, const Vec<Dim>& x) const;

    Points<Dim> corners_;
    std::vector<Item> items_;
    std::vector<Box> boxes_;
};

}  // namespace pfem
