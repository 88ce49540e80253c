#include "linear/denseFront.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "linear/tiles.hpp"

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

/// sum = L21^T below of n columns of L21, each as eight sums side by side that need not wait for each other.
template <int n, class Stored>
PFEM_INLINE void productsBelow(const Stored* L21, int m, int r, const double* below, double* sum) {
    double parts[n][lanes] = {};
    int i = 0;
    for (; i + lanes <= r; i += lanes)
        for (int c = 0; c < n; ++c)
            for (int l = 0; l < lanes; ++l) parts[c][l] += L21[static_cast<long>(c) * m + i + l] * below[i + l];
    for (int c = 0; c < n; ++c)
        for (int l = 0; i + l < r; ++l) parts[c][l] += L21[static_cast<long>(c) * m + i + l] * below[i + l];
    for (int c = 0; c < n; ++c) {
        sum[c] = 0;
        for (const double part : parts[c]) sum[c] += part;
    }
}

/// The last n of the first `end` columns.
template <int n, class Stored>
PFEM_INLINE void substituteLast(const Stored* L, int m, int width, int end, const double* below, double* own) {
    const Stored* const first = L + static_cast<long>(end - n) * m;
    double sum[n];
    productsBelow<n>(first + width, m, m - width, below, sum);
    for (int c = n - 1; c >= 0; --c) {
        const int k = end - n + c;
        const Stored* const column = first + static_cast<long>(c) * m;
        for (int i = k + 1; i < width; ++i) sum[c] += column[i] * own[i];
        own[k] = own[k] / column[k] - sum[c];
    }
}

template <class Stored>
PFEM_INLINE void substitute(const Stored* L, int m, int width, const double* below, double* own) {
    int end = width;
    for (; end % 4 != 0; --end) substituteLast<1>(L, m, width, end, below, own);
    for (; end > 0; end -= 4) substituteLast<4>(L, m, width, end, below, own);
}

/// U -= L21 D L21^T, four columns of L21 at a time.
template <class Real>
PFEM_INLINE void subtractByColumns(Real* U, int r, const Real* F, int m, int width) {
    const Real* const below = F + (m - r);
    int k = 0;
    for (; k + 4 <= width; k += 4) {
        const Real* const a = below + static_cast<long>(k) * m;
        const Real* const b = a + m;
        const Real* const c = b + m;
        const Real* const d = c + m;
        const Real da = F[static_cast<long>(k) * m + k], db = F[static_cast<long>(k + 1) * m + k + 1];
        const Real dc = F[static_cast<long>(k + 2) * m + k + 2], dd = F[static_cast<long>(k + 3) * m + k + 3];
        for (int j = 0; j < r; ++j) {
            Real* const u = U + packedColumn(j, r);
            const Real ca = da * a[j], cb = db * b[j], cc = dc * c[j], cd = dd * d[j];
            for (int i = j; i < r; ++i) u[i] -= (ca * a[i] + cb * b[i]) + (cc * c[i] + cd * d[i]);
        }
    }
    for (; k < width; ++k) {
        const Real* const a = below + static_cast<long>(k) * m;
        const Real da = F[static_cast<long>(k) * m + k];
        for (int j = 0; j < r; ++j) {
            Real* const u = U + packedColumn(j, r);
            const Real ca = da * a[j];
            for (int i = j; i < r; ++i) u[i] -= ca * a[i];
        }
    }
}

/// Columns begin ... end - 1 take what those before them in this range leave, one after the other; the column's own
/// entries stay as they are (they are divided by the pivots at the end).
template <class Real>
PFEM_INLINE bool factorPanel(Real* F, int m, int begin, int end, Real* inverse) {
    for (int k = begin; k < end; ++k) {
        const Real* const column = F + static_cast<long>(k) * m;
        const Real pivot = column[k];
        if (pivot == 0 || !std::isfinite(pivot)) return false;
        inverse[k] = 1 / pivot;
        for (int j = k + 1; j < end; ++j) {
            const Real c = column[j] * inverse[k];
            Real* const other = F + static_cast<long>(j) * m;
            for (int i = j; i < m; ++i) other[i] -= c * column[i];
        }
    }
    return true;
}

/// Columns from `end` on take what begin ... end - 1 leave.
template <class Real>
PFEM_INLINE void applyPanel(Real* F, int m, int width, int begin, int end, const Real* inverse) {
    const int n = end - begin;
    Tiles<Real> tiles(m - end, width - end, n);
    for (int k = 0; k < n; ++k) {
        const Real* const column = F + static_cast<long>(begin + k) * m;
        tiles.setFactors(k, [&](int j) { return column[end + j] * inverse[begin + k]; });
    }
    for (int i = 0; i < m - end; i += tileRows<Real>) {
        const Real* const strip = tiles.strip(F + static_cast<long>(begin) * m + end, m, i);
        for (int j = 0; j < std::min(width - end, i + tileRows<Real>); j += tileColumns)
            tiles.update(
                i, j, [&](int column) { return F + static_cast<long>(end + column) * m + end; },
                [&](Tile<Real>& tile) { subtractSingly(tile, strip, tiles.factors(j), n); });
    }
}

/// U -= L21 D L21^T by tiles, the same bits as by columns.
template <class Real>
PFEM_INLINE void subtractByTiles(Real* U, int r, const Real* F, int m, int width) {
    const Real* const below = F + (m - r);
    for (int begin = 0; begin < width; begin += depth) {
        const int n = std::min(depth, width - begin);
        Tiles<Real> tiles(r, r, n);
        for (int k = 0; k < n; ++k) {
            const Real* const column = below + static_cast<long>(begin + k) * m;
            const Real d = F[static_cast<long>(begin + k) * m + begin + k];
            tiles.setFactors(k, [&](int j) { return d * column[j]; });
        }
        for (int i = 0; i < r; i += tileRows<Real>) {
            const Real* const strip = tiles.strip(below + static_cast<long>(begin) * m, m, i);
            for (int j = 0; j < std::min(r, i + tileRows<Real>); j += tileColumns)
                tiles.update(
                    i, j, [&](int column) { return U + packedColumn(column, r); },
                    [&](Tile<Real>& tile) { subtractByFours(tile, strip, tiles.factors(j), n); });
        }
    }
}

template <class Real>
PFEM_INLINE bool factor(Real* F, int m, int width) {
    std::vector<Real> inverse(width);
    for (int begin = 0, end = 0; end < width; begin = end) {
        end = width < 2 * panelWidth ? width : std::min(width, begin + panelWidth);
        if (!factorPanel(F, m, begin, end, inverse.data())) return false;
        if (end < width) applyPanel(F, m, width, begin, end, inverse.data());
    }
    for (int k = 0; k < width; ++k) {
        Real* const column = F + static_cast<long>(k) * m;
        for (int i = k + 1; i < m; ++i) column[i] *= inverse[k];
    }
    return true;
}

template <class Real>
PFEM_INLINE void subtract(Real* U, int r, const Real* F, int m, int width) {
    constexpr long layingOut = 4800;  // fewer numbers of L21 are not worth it (same bits)
    if (static_cast<long>(r) * width >= layingOut)
        subtractByTiles(U, r, F, m, width);
    else
        subtractByColumns(U, r, F, m, width);
}

}  // namespace

PFEM_WIDE bool factorColumns(float* F, int m, int width) { return factor(F, m, width); }
PFEM_WIDE bool factorColumns(double* F, int m, int width) { return factor(F, m, width); }

PFEM_WIDE void subtractProduct(float* U, int r, const float* F, int m, int width) { subtract(U, r, F, m, width); }
PFEM_WIDE void subtractProduct(double* U, int r, const double* F, int m, int width) { subtract(U, r, F, m, width); }

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
