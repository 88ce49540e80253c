#include "mesher/hilbertOrder.hpp"

#include <algorithm>

namespace pfem {

namespace {

/// Distance along the curve that fills a square of 2^bits by 2^bits cells.
std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y, int bits) {
    std::uint64_t index = 0;
    for (std::uint32_t side = 1u << (bits - 1); side > 0; side >>= 1) {
        const std::uint32_t right = (x & side) ? 1 : 0, top = (y & side) ? 1 : 0;
        index = 4 * index + ((3 * right) ^ top);
        if (top == 0) {  // the lower quadrants are turned
            if (right == 1) {
                x = ~x;
                y = ~y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

}  // namespace

std::vector<int> hilbertOrder(const Points<2>& points) {
    if (points.empty()) return {};
    Vec<2> low = points.front(), high = low;
    for (const auto& x : points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    constexpr int bits = 20;
    const double extent = (high - low).maxCoeff();
    const double scale = extent > 0 ? ((1u << bits) - 1) / extent : 0.0;
    const Vec<2> roundOff = Vec<2>::Constant(1e-6);  // of a cell: what lies on its border belongs to it
    std::vector<std::pair<std::uint64_t, int>> keyed;
    keyed.reserve(points.size());
    for (const auto& x : points) {
        const Vec<2> cell = scale * (x - low) + roundOff;
        keyed.emplace_back(
            hilbertIndex(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y()), bits),
            static_cast<int>(keyed.size()));
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<int> order;
    order.reserve(keyed.size());
    for (const auto& [key, i] : keyed) order.push_back(i);
    return order;
}

}  // namespace pfem
