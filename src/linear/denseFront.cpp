#include "linear/denseFront.hpp"

#include <cmath>

// Wider registers where the processor has them; elementwise operations, so that the bits are the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PFEM_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PFEM_WIDE
#endif

namespace pfem {

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
            double* const u = U + static_cast<long>(j) * r;
            const double ca = da * a[j], cb = db * b[j], cc = dc * c[j], cd = dd * d[j];
            for (int i = j; i < r; ++i) u[i] -= (ca * a[i] + cb * b[i]) + (cc * c[i] + cd * d[i]);
        }
    }
    for (; k < width; ++k) {
        const double* const a = below + static_cast<long>(k) * m;
        const double da = F[static_cast<long>(k) * m + k];
        for (int j = 0; j < r; ++j) {
            double* const u = U + static_cast<long>(j) * r;
            const double ca = da * a[j];
            for (int i = j; i < r; ++i) u[i] -= ca * a[i];
        }
    }
}

}  // namespace pfem
