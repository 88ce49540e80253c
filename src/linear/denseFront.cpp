#include "linear/denseFront.hpp"

#include <cmath>

// Wider registers where the processor has them; elementwise operations, so that the bits are the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PFEM_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#define PFEM_INLINE inline __attribute__((always_inline))  // into each of the clones
#else
#define PFEM_WIDE
#define PFEM_INLINE inline
#endif

namespace pfem {

namespace {

constexpr int lanes = 8;

template <class Stored>
PFEM_INLINE void eliminate(const Stored* L, int m, int width, double* own, double* below) {
    const int r = m - width;
    for (int k = 0; k < width; ++k) {
        const Stored* const column = L + static_cast<long>(k) * m;
        for (int i = k + 1; i < width; ++i) own[i] -= column[i] * own[k];
    }
    int k = 0;
    for (; k + 4 <= width; k += 4) {
        const Stored* const a = L + static_cast<long>(k) * m + width;
        const Stored *const b = a + m, *const c = b + m, *const d = c + m;
        const double ya = own[k], yb = own[k + 1], yc = own[k + 2], yd = own[k + 3];
        for (int i = 0; i < r; ++i) below[i] += (a[i] * ya + b[i] * yb) + (c[i] * yc + d[i] * yd);
    }
    for (; k < width; ++k) {
        const Stored* const a = L + static_cast<long>(k) * m + width;
        for (int i = 0; i < r; ++i) below[i] += a[i] * own[k];
    }
}

template <class Stored>
PFEM_INLINE void substitute(const Stored* L, int m, int width, const double* below, double* own) {
    const int r = m - width;
    for (int k = width - 1; k >= 0; --k) {
        const Stored* const column = L + static_cast<long>(k) * m;
        double sums[lanes] = {};  // side by side, so that they need not wait for each other
        int i = 0;
        for (; i + lanes <= r; i += lanes)
            for (int l = 0; l < lanes; ++l) sums[l] += column[width + i + l] * below[i + l];
        for (; i < r; ++i) sums[i % lanes] += column[width + i] * below[i];
        double sum = 0;
        for (const double part : sums) sum += part;
        for (i = k + 1; i < width; ++i) sum += column[i] * own[i];
        own[k] = own[k] / column[k] - sum;
    }
}

}  // namespace

PFEM_WIDE bool factorColumns(double* F, int m, int width) {
    for (int k = 0; k < width; ++k) {
        double* const column = F + static_cast<long>(k) * m;
        const double pivot = column[k];
        if (pivot == 0 || !std::isfinite(pivot)) return false;
        const double inverse = 1 / pivot;
        for (int j = k + 1; j < width; ++j) {
            const double c = column[j] * inverse;
            double* const other = F + static_cast<long>(j) * m;
            for (int i = j; i < m; ++i) other[i] -= c * column[i];
        }
        for (int i = k + 1; i < m; ++i) column[i] *= inverse;
    }
    return true;
}

PFEM_WIDE void subtractProduct(double* U, int r, const double* F, int m, int width) {
    const double* const below = F + (m - r);
    int k = 0;
    for (; k + 4 <= width; k += 4) {
        const double* const a = below + static_cast<long>(k) * m;
        const double* const b = a + m;
        const double* const c = b + m;
        const double* const d = c + m;
        const double da = F[static_cast<long>(k) * m + k], db = F[static_cast<long>(k + 1) * m + k + 1];
        const double dc = F[static_cast<long>(k + 2) * m + k + 2], dd = F[static_cast<long>(k + 3) * m + k + 3];
        for (int j = 0; j < r; ++j) {
            double* const u = U + packedColumn(j, r);
            const double ca = da * a[j], cb = db * b[j], cc = dc * c[j], cd = dd * d[j];
            for (int i = j; i < r; ++i) u[i] -= (ca * a[i] + cb * b[i]) + (cc * c[i] + cd * d[i]);
        }
    }
    for (; k < width; ++k) {
        const double* const a = below + static_cast<long>(k) * m;
        const double da = F[static_cast<long>(k) * m + k];
        for (int j = 0; j < r; ++j) {
            double* const u = U + packedColumn(j, r);
            const double ca = da * a[j];
            for (int i = j; i < r; ++i) u[i] -= ca * a[i];
        }
    }
}

PFEM_WIDE void eliminateColumns(const float* L, int m, int width, double* own, double* below) {
    eliminate(L, m, width, own, below);
}
PFEM_WIDE void eliminateColumns(const double* L, int m, int width, double* own, double* below) {
    eliminate(L, m, width, own, below);
}

PFEM_WIDE void substituteColumns(const float* L, int m, int width, const double* below, double* own) {
    substitute(L, m, width, below, own);
}
PFEM_WIDE void substituteColumns(const double* L, int m, int width, const double* below, double* own) {
    substitute(L, m, width, below, own);
}

}  // namespace pfem
