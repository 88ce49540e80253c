#pragma once
// Square bins for neighbour searches: what lies near a point, without looking at everything.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/types.hpp"

namespace pfem {

class BinGrid {
public:
    explicit BinGrid(double width) : width_(width) {}

    /// Put `item` into all bins that the box from `low` to `high` touches.
    void add(int item, const Vec<2>& low, const Vec<2>& high) {
        visit(low, high, [&](std::int64_t key) { bins_[key].push_back(item); });
    }
    void addSegment(int item, const Vec<2>& a, const Vec<2>& b) { add(item, a.cwiseMin(b), a.cwiseMax(b)); }

    /// f(item) for everything in the bins touched by the box; an item in several bins comes several times.
    template <class F>
    void forEach(const Vec<2>& low, const Vec<2>& high, F&& f) const {
        visit(low, high, [&](std::int64_t key) {
            if (const auto it = bins_.find(key); it != bins_.end())
                for (const int item : it->second) f(item);
        });
    }

    /// f(item) for everything that may lie within `radius` of x.
    template <class F>
    void forEachNear(const Vec<2>& x, double radius, F&& f) const {
        const Vec<2> r(radius, radius);
        forEach(x - r, x + r, f);
    }

private:
    template <class F>
    void visit(const Vec<2>& low, const Vec<2>& high, F&& f) const {
        const auto bin = [&](double c) { return static_cast<std::int64_t>(std::floor(c / width_)); };
        for (std::int64_t i = bin(low.x()); i <= bin(high.x()); ++i)
            for (std::int64_t j = bin(low.y()); j <= bin(high.y()); ++j) f(i * 0x40000000LL + j);
    }

    double width_;
    std::unordered_map<std::int64_t, std::vector<int>> bins_;
};

/// Distance of x from the segment a-b.
inline double segmentDistance(const Vec<2>& x, const Vec<2>& a, const Vec<2>& b) {
    const Vec<2> d = b - a;
    const double s = std::clamp((x - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (a + s * d - x).norm();
}

}  // namespace pfem
