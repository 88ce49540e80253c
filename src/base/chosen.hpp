#pragma once
// Those of many for which something holds, looked for by threads.

#include "base/parallel.hpp"

namespace pfem {

/// Those of 0 ... n - 1 for which holds(i), in ascending order.
template <class Holds>
std::vector<int> parallelChosen(int n, const Holds& holds) {
    constexpr int block = 4096;
    const int nBlocks = (n + block - 1) / block;
    std::vector<std::vector<int>> found(nBlocks);
#pragma omp parallel for schedule(static) if (n > shortLoop)
    for (int b = 0; b < nBlocks; ++b)
        for (int i = b * block; i < n && i < (b + 1) * block; ++i)
            if (holds(i)) found[b].push_back(i);
    std::size_t count = 0;
    for (const auto& each : found) count += each.size();
    std::vector<int> all;
    all.reserve(count);
    for (const auto& each : found) all.insert(all.end(), each.begin(), each.end());
    return all;
}

}  // namespace pfem
