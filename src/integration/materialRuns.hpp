#pragma once
// Stress points in runs of one material, so that a law is asked for many points in one call.

#include <algorithm>
#include <exception>
#include <span>

#include "base/parallel.hpp"
#include "integration/stressPoints.hpp"
#include "mesh/mesh.hpp"

namespace pfem {

/// work(material, first, last) for runs first ... last - 1 of stress points of one material, of this process's share,
/// in parallel where they are many; none is longer than 256. Throws what the first of the works has thrown.
template <int Dim, class Work>
void forMaterialRuns(const SmoothingDomains<Dim>& domains, const Share& share, const Cells<Dim>& cells,
                     const Work& work) {
    constexpr int block = 256;
    const bool isWhole = share.isWhole(), isNodal = domains.scheme == Integration::nodal;
    const std::vector<int>* list = isWhole ? nullptr : isNodal ? &share.nodes() : &share.cells();
    const int n = list ? static_cast<int>(list->size()) : nStressPoints<Dim>(domains);
    const int nBlocks = (n + block - 1) / block;
    const auto pointAt = [list](int k) { return list ? (*list)[k] : k; };
    const auto materialOf = [&](int p) {
        return isStressPoint<Dim>(domains, p) ? cells.material[cellOfPoint<Dim>(domains, p)] : -1;
    };
    std::vector<std::exception_ptr> failed(nBlocks);
#pragma omp parallel for schedule(static) if (n > shortLoop)
    for (int b = 0; b < nBlocks; ++b) {
        try {
            const int end = std::min(n, (b + 1) * block);
            for (int k = b * block, next = k; k < end; k = next) {
                const int first = pointAt(k), material = materialOf(first);
                const auto goesOn = [&](int point) {
                    return point == first + next - k && materialOf(point) == material;
                };
                for (next = k + 1; next < end && goesOn(pointAt(next));) ++next;
                if (material >= 0) work(material, first, first + next - k);
            }
        } catch (...) {
            failed[b] = std::current_exception();
        }
    }
    for (const auto& failure : failed)
        if (failure) std::rethrow_exception(failure);
}

/// The same of the domains' own share.
template <int Dim, class Work>
void forMaterialRuns(const SmoothingDomains<Dim>& domains, const Cells<Dim>& cells, const Work& work) {
    forMaterialRuns<Dim>(domains, domains.share, cells, work);
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
