#pragma once
// Products of dense columns by tiles that stay in the registers. Each number takes its terms in the same order as
// column by column: the bits do not depend on the tiles, nor on how wide the registers are.

#include <algorithm>
#include <cstring>
#include <vector>

// Wider registers where the processor has them; elementwise operations, so that the bits are the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PFEM_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#define PFEM_INLINE inline __attribute__((always_inline))  // into each of the clones
#else
#define PFEM_WIDE
#define PFEM_INLINE inline
#endif

namespace pfem {

constexpr int lanesOfTile = 2;
constexpr int tileColumns = 4;
constexpr int depth = 128;      // columns that a strip of rows keeps in the first cache; a multiple of four
constexpr int panelWidth = 16;  // columns that are factored one by one

/// Numbers of one register of 64 bytes, at any address: eight of double precision, sixteen of single.
template <class Real>
struct LaneOf {
    using Type [[gnu::vector_size(64), gnu::aligned(alignof(Real))]] = Real;
    static constexpr int numbers = 64 / sizeof(Real);
};
template <class Real>
using Lane = typename LaneOf<Real>::Type;

template <class Real>
constexpr int tileRows = lanesOfTile* LaneOf<Real>::numbers;

/// tileRows x tileColumns numbers.
template <class Real>
struct Tile {
    Lane<Real> u[tileColumns][lanesOfTile];
};

/// u -= a c for one column after the other. strip: n x tileRows; factors: n x tileColumns.
template <class Real>
PFEM_INLINE void subtractSingly(Tile<Real>& tile, const Real* strip, const Real* factors, int n) {
    Tile<Real> t = tile;
    for (int k = 0; k < n; ++k, strip += tileRows<Real>, factors += tileColumns) {
        // NOLINTNEXTLINE(modernize-use-auto): auto would lose that the address is any
        const Lane<Real>* const a = reinterpret_cast<const Lane<Real>*>(strip);
        for (int j = 0; j < tileColumns; ++j)
            for (int l = 0; l < lanesOfTile; ++l) t.u[j][l] -= factors[j] * a[l];
    }
    tile = t;
}

/// u -= (a0 c0 + a1 c1) + (a2 c2 + a3 c3) for four columns after four, the rest one by one.
template <class Real>
PFEM_INLINE void subtractByFours(Tile<Real>& tile, const Real* strip, const Real* factors, int n) {
    Tile<Real> t = tile;
    int k = 0;
    for (; k + 4 <= n; k += 4, strip += 4 * tileRows<Real>, factors += 4 * tileColumns)
        for (int l = 0; l < lanesOfTile; ++l) {
            const Lane<Real>* const a = reinterpret_cast<const Lane<Real>*>(strip) + l;
            const Lane<Real> a0 = a[0], a1 = a[lanesOfTile], a2 = a[2 * lanesOfTile], a3 = a[3 * lanesOfTile];
            for (int j = 0; j < tileColumns; ++j)
                t.u[j][l] -= (factors[j] * a0 + factors[tileColumns + j] * a1) +
                             (factors[2 * tileColumns + j] * a2 + factors[3 * tileColumns + j] * a3);
        }
    tile = t;
    if (k < n) subtractSingly(tile, strip, factors, n - k);
}

/// The columns j of a lower triangle's rows i >= j, n products deep, cut into tiles.
template <class Real>
class Tiles {
public:
    static constexpr int tileRows = pfem::tileRows<Real>;

    Tiles(int nRows, int nColumns, int n)
        : nRows_(nRows), nColumns_(nColumns), n_(n), strip_(static_cast<std::size_t>(n) * tileRows) {
        const int blocks = (nColumns + tileColumns - 1) / tileColumns;
        factors_.assign(static_cast<std::size_t>(blocks) * tileColumns * n, 0.0);
    }

    /// The factors of the k-th product for all columns.
    template <class Value>
    PFEM_INLINE void setFactors(int k, const Value& value) {
        for (int j = 0; j < nColumns_; ++j)
            factors_[(static_cast<std::size_t>(j / tileColumns) * n_ + k) * tileColumns + j % tileColumns] = value(j);
    }
    const Real* factors(int j) const { return factors_.data() + static_cast<std::size_t>(j) * n_; }

    /// Rows i ... i + tileRows - 1 of n columns, of m numbers each, side by side; zeros below the last row.
    PFEM_INLINE const Real* strip(const Real* columns, int m, int i) {
        const int rows = std::min(tileRows, nRows_ - i);
        for (int k = 0; k < n_; ++k) {
            Real* const to = strip_.data() + static_cast<std::size_t>(k) * tileRows;
            const Real* const from = columns + static_cast<long>(k) * m + i;
            if (rows == tileRows)
                std::memcpy(to, from, sizeof(Real) * tileRows);
            else
                for (int l = 0; l < tileRows; ++l) to[l] = l < rows ? from[l] : 0.0;
        }
        return strip_.data();
    }

    /// Take the tile at (i, j) out of the triangle, whose column c is at column(c)[row], change it and put it back.
    template <class Column, class Change>
    PFEM_INLINE void update(int i, int j, const Column& column, const Change& change) const {
        Tile<Real> tile;
        if (j + tileColumns - 1 <= i && j + tileColumns <= nColumns_ && i + tileRows <= nRows_) {
            for (int c = 0; c < tileColumns; ++c) std::memcpy(tile.u[c], column(j + c) + i, sizeof tile.u[c]);
            change(tile);
            for (int c = 0; c < tileColumns; ++c) std::memcpy(column(j + c) + i, tile.u[c], sizeof tile.u[c]);
            return;
        }
        Real part[tileColumns][tileRows] = {};
        const auto forEntries = [&](const auto& visit) {
            for (int c = 0; c < std::min(tileColumns, nColumns_ - j); ++c)
                for (int l = std::max(0, j + c - i); l < std::min(tileRows, nRows_ - i); ++l)
                    visit(part[c][l], column(j + c)[i + l]);
        };
        forEntries([](Real& own, Real& other) { own = other; });
        std::memcpy(tile.u, part, sizeof part);
        change(tile);
        std::memcpy(part, tile.u, sizeof part);
        forEntries([](Real& own, Real& other) { other = own; });
    }

private:
    int nRows_, nColumns_, n_;
    std::vector<Real> strip_, factors_;
};

}  // namespace pfem
