#pragma once
// When a second thread pays.

#include <omp.h>

#include <algorithm>
#include <exception>
#include <vector>

namespace pfem {

/// Loops over fewer items than this stay in one thread: waking another takes longer (tens of microseconds).
inline constexpr int shortLoop = 1500;
inline constexpr int shortLongLoop = 150;  // where each item takes microseconds

/// How many items a thread takes at a time: where only some have work (nodes of solids) these follow each other, so
/// each has sixteen turns; more would be slower for long arrays.
inline int itemsPerTurn(int n) { return std::max(64, n / (16 * omp_get_max_threads())); }

/// work(0) ... work(n - 1), in parallel where they are many. They must not depend on each other nor throw.
template <class Work>
void parallelFor(int n, const Work& work, int few = shortLoop) {
#pragma omp parallel for schedule(static, itemsPerTurn(n)) if (n > few)
    for (int i = 0; i < n; ++i) work(i);
}

/// The first i of 0 ... n - 1 for which holds(i), or n.
template <class Holds>
int parallelFirst(int n, const Holds& holds) {
    int first = n;
#pragma omp parallel for schedule(static) reduction(min : first) if (n > shortLoop)
    for (int i = 0; i < n; ++i)
        if (holds(i)) first = std::min(first, i);
    return first;
}

/// value(0) + ... + value(n - 1), in parallel where they are many: sums of blocks, so that the bits do not depend on
/// the number of threads. Numbers, or anything that begins with zero and has +=.
template <class Value>
auto parallelSum(int n, const Value& value) {
    using Sum = decltype(value(0));
    constexpr int block = 512;
    const int nBlocks = (n + block - 1) / block;
    std::vector<Sum> sums(nBlocks);
#pragma omp parallel for schedule(static) if (n > shortLoop)
    for (int b = 0; b < nBlocks; ++b) {
        Sum sum{};
        for (int i = b * block; i < n && i < (b + 1) * block; ++i) sum += value(i);
        sums[b] = sum;
    }
    Sum total{};
    for (const Sum& sum : sums) total += sum;
    return total;
}

/// work(0) ... work(n - 1) for few but long ones, at the same time; throws what the first of them has thrown.
template <class Work>
void parallelTasks(int n, const Work& work) {
    std::vector<std::exception_ptr> failed(n);
#pragma omp parallel for schedule(static, 1) if (n > 1)  // a single one has its own loops in parallel
    for (int k = 0; k < n; ++k) {
        try {
            work(k);
        } catch (...) {
            failed[k] = std::current_exception();
        }
    }
    for (const auto& failure : failed)
        if (failure) std::rethrow_exception(failure);
}

/// a() and b(), at the same time where `items` are many; throws what a, or else b, has thrown.
template <class A, class B>
void parallelInvoke(int items, const A& a, const B& b) {
    std::exception_ptr failed[2];
#pragma omp parallel sections if (items > shortLoop)
    {
#pragma omp section
        try {
            a();
        } catch (...) {
            failed[0] = std::current_exception();
        }
#pragma omp section
        try {
            b();
        } catch (...) {
            failed[1] = std::current_exception();
        }
    }
    for (const auto& failure : failed)
        if (failure) std::rethrow_exception(failure);
}

}  // namespace pfem
