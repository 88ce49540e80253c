#include <algorithm>

#include "mesher/space/hilbertOrder3.hpp"

namespace pfem {

namespace {

/// Distance along the curve that fills a cube of 2^bits cells a side (Skilling's transposed form).
std::uint64_t hilbertIndex(std::array<std::uint32_t, 3> x, int bits) {
    const std::uint32_t highest = 1u << (bits - 1);
    for (std::uint32_t q = highest; q > 1; q >>= 1)
        for (int i = 0; i < 3; ++i) {
            if (x[i] & q) {
                x[0] ^= q - 1;  // turned round
            } else {
                const std::uint32_t t = (x[0] ^ x[i]) & (q - 1);
                x[0] ^= t;
                x[i] ^= t;
            }
        }
    for (int i = 1; i < 3; ++i) x[i] ^= x[i - 1];
    std::uint32_t t = 0;
    for (std::uint32_t q = highest; q > 1; q >>= 1)
        if (x[2] & q) t ^= q - 1;
    for (auto& c : x) c ^= t;
    std::uint64_t index = 0;
    for (int b = bits - 1; b >= 0; --b)
        for (const auto c : x) index = 2 * index + ((c >> b) & 1);
    return index;
}

}  // namespace

std::vector<int> hilbertOrder3(const Points<3>& points) {
    if (points.empty()) return {};
    Vec<3> low = points.front(), high = low;
    for (const auto& x : points) {
        low = low.cwiseMin(x).eval();
        high = high.cwiseMax(x).eval();
    }
    constexpr int bits = 20;
    const double extent = (high - low).maxCoeff();
    const double scale = extent > 0 ? ((1u << bits) - 1) / extent : 0.0;
    std::vector<std::pair<std::uint64_t, int>> keyed;
    for (const auto& x : points) {
        const Vec<3> cell = scale * (x - low) + Vec<3>::Constant(1e-6);  // what lies on a border belongs to the cell
        keyed.emplace_back(hilbertIndex({static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1]),
                                         static_cast<std::uint32_t>(cell[2])},
                                        bits),
                           static_cast<int>(keyed.size()));
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<int> order;
    for (const auto& [key, i] : keyed) order.push_back(i);
    return order;
}

}  // namespace pfem
