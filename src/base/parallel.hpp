#pragma once
// When a second thread pays.

namespace pfem {

/// Loops over fewer items than this stay in one thread: waking another takes longer (tens of microseconds).
inline constexpr int shortLoop = 1500;

}  // namespace pfem
