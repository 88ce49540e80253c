#pragma once
// When a second thread pays.

#include <exception>

namespace pfem {

/// Loops over fewer items than this stay in one thread: waking another takes longer (tens of microseconds).
inline constexpr int shortLoop = 1500;

/// work(0) ... work(n - 1), in parallel where they are many. They must not depend on each other nor throw.
template <class Work>
void forEach(int n, const Work& work) {
#pragma omp parallel for schedule(static) if (n > shortLoop)
    for (int i = 0; i < n; ++i) work(i);
}

/// a() and b(), at the same time where `items` are many; throws what a, or else b, has thrown.
template <class A, class B>
void together(int items, const A& a, const B& b) {
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
