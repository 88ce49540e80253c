#pragma once
// Stress points in runs of one material, so that a law is asked for many points in one call.

#include <algorithm>
#include <exception>
#include <span>

#include "base/parallel.hpp"
#include "integration/stressPoints.hpp"
#include "mesh/mesh.hpp"

namespace pfem {

/// work(material, first, last) for runs first ... last - 1 of stress points of one material, in parallel where they are
/// many; none is longer than 256. Throws what the first of the works has thrown.
template <int Dim, class Work>
void forMaterialRuns(const SmoothingDomains<Dim>& domains, const Cells<Dim>& cells, const Work& work) {
    constexpr int block = 256;
    const int n = nStressPoints<Dim>(domains), nBlocks = (n + block - 1) / block;
    const auto materialOf = [&](int p) {
        return isStressPoint<Dim>(domains, p) ? cells.material[cellOfPoint<Dim>(domains, p)] : -1;
    };
    std::vector<std::exception_ptr> failed(nBlocks);
#pragma omp parallel for schedule(static) if (n > shortLoop)
    for (int b = 0; b < nBlocks; ++b) {
        try {
            const int end = std::min(n, (b + 1) * block);
            for (int first = b * block, last = first; first < end; first = last) {
                const int material = materialOf(first);
                for (last = first + 1; last < end && materialOf(last) == material;) ++last;
                if (material >= 0) work(material, first, last);
            }
        } catch (...) {
            failed[b] = std::current_exception();
        }
    }
    for (const auto& failure : failed)
        if (failure) std::rethrow_exception(failure);
}

/// Points first ... last - 1 of a field.
template <class Value>
std::span<const Value> runOf(const PerPoint<Value>& field, int first, int last) {
    return std::span<const Value>(field.data(), field.size()).subspan(first, last - first);
}
template <class Value>
std::span<Value> runOf(PerPoint<Value>& field, int first, int last) {
    return std::span<Value>(field.data(), field.size()).subspan(first, last - first);
}

}  // namespace pfem
