#pragma once
// Numbers of single precision that are smaller than the least normal one.

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace pfem {

/// While it lives they are zero in this thread, on processors of x86-64: entries of a factor fall off with the distance
/// of what they join, and arithmetic with numbers below 1e-38 takes a hundred times as long.
class FlushToZero {
public:
#if defined(__SSE2__)
    FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | resultsToZero | operandsAreZero); }
    ~FlushToZero() { _mm_setcsr(before_); }
#else
    FlushToZero() {}
    ~FlushToZero() {}
#endif
    FlushToZero(const FlushToZero&) = delete;
    FlushToZero& operator=(const FlushToZero&) = delete;

private:
#if defined(__SSE2__)
    static constexpr unsigned resultsToZero = 0x8000, operandsAreZero = 0x0040;
    unsigned before_;
#endif
};

}  // namespace pfem
