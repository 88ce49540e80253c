#pragma once
// Dense kernels of a front: column-major, lower triangles.

#include <cstddef>

namespace pfem {

/// The first `width` columns of the m x m matrix F = [F11; F21], stored m x width, become D (diagonal) and the unit
/// lower L. Returns false when a pivot is zero or not finite.
bool factorColumns(float* F, int m, int width);
bool factorColumns(double* F, int m, int width);

/// Numbers in a lower triangle of r columns, packed one behind the other.
inline std::size_t packedSize(int r) { return static_cast<std::size_t>(r) * (r + 1) / 2; }

/// Its element (i, j), i >= j, is at packedColumn(j, r) + i.
inline std::size_t packedColumn(int j, int r) { return static_cast<std::size_t>(j) * r - packedSize(j); }

/// U -= L21 D L21^T: U is a packed lower triangle of r columns, L21 the last r rows of the factored m x width block.
void subtractProduct(float* U, int r, const float* F, int m, int width);
void subtractProduct(double* U, int r, const double* F, int m, int width);

/// own = L11^{-1} own, below = L21 own (zeros on entry) with a factored m x width block, stored in single or double
/// precision.
void eliminateColumns(const float* L, int m, int width, double* own, double* below);
void eliminateColumns(const double* L, int m, int width, double* own, double* below);

/// own = L11^{-T} (D^{-1} own - L21^T below) with such a block.
void substituteColumns(const float* L, int m, int width, const double* below, double* own);
void substituteColumns(const double* L, int m, int width, const double* below, double* own);

}  // namespace pfem
