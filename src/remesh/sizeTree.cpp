#include "remesh/sizeTree.hpp"

#include <algorithm>

#include "mesh/distance.hpp"

namespace pfem {

template <int Dim>
void SizeTree<Dim>::add(const typename SizePlace<Dim>::Corners& corners, double size, double reach) {
    Item item{{}, size, reach};
    for (int k = 0; k < Dim; ++k) {
        item.corners[k] = static_cast<int>(corners_.size());
        corners_.push_back(corners[k]);
    }
    items_.push_back(item);
}

template <int Dim>
void SizeTree<Dim>::build() {
    boxes_.clear();
    if (!items_.empty()) build(0, static_cast<int>(items_.size()));
}

template <int Dim>
typename SizeTree<Dim>::Box SizeTree<Dim>::boxOf(int first, int last) const {
    const Item& start = items_[first];
    Box box{corners_[start.corners[0]], corners_[start.corners[0]], start.size, start.size, first, last};
    for (int k = first; k < last; ++k) {
        box.size = std::min(box.size, items_[k].size);
        box.offset = std::min(box.offset, items_[k].size - sizeGrowth * items_[k].reach);
        for (const int corner : items_[k].corners) {
            box.low = box.low.cwiseMin(corners_[corner]).eval();
            box.high = box.high.cwiseMax(corners_[corner]).eval();
        }
    }
    return box;
}

template <int Dim>
int SizeTree<Dim>::build(int first, int last) {
    const int self = static_cast<int>(boxes_.size());
    boxes_.push_back(boxOf(first, last));
    if (last - first <= 4) return self;
    int axis = 0;
    (boxes_[self].high - boxes_[self].low).maxCoeff(&axis);
    const int middle = (first + last) / 2;
    const auto isBefore = [&](const Item& a, const Item& b) {
        return corners_[a.corners[0]][axis] < corners_[b.corners[0]][axis];
    };
    std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last, isBefore);
    const int left = build(first, middle), right = build(middle, last);
    boxes_[self].left = left;
    boxes_[self].right = right;
    return self;
}

template <int Dim>
double SizeTree<Dim>::sizeAt(const Item& item, const Vec<Dim>& x) const {
    return item.size + sizeGrowth * std::max(0.0, distanceToFace<Dim>(corners_, item.corners, x) - item.reach);
}

template <int Dim>
double SizeTree<Dim>::at(const Vec<Dim>& x, double most) const {
    if (boxes_.empty()) return most;
    std::array<int, 64> stack{};
    int n = 1;
    while (n > 0) {
        const Box& box = boxes_[stack[--n]];
        if (box.bound(x) >= most) continue;
        if (box.left >= 0) {
            const bool leftFirst = boxes_[box.left].bound(x) < boxes_[box.right].bound(x);
            stack[n++] = leftFirst ? box.right : box.left;
            stack[n++] = leftFirst ? box.left : box.right;
            continue;
        }
        for (int k = box.first; k < box.last; ++k) most = std::min(most, sizeAt(items_[k], x));
    }
    return most;
}

template class SizeTree<2>;
template class SizeTree<3>;

}  // namespace pfem
