#pragma once
// Dense kernels of a front: column-major, lower triangles.

namespace pfem {

/// The first `width` columns of the m x m matrix F = [F11; F21], stored m x width, become D (diagonal) and the unit
/// lower L. Returns false when a pivot is zero or not finite.
bool factorColumns(double* F, int m, int width);

/// U -= L21 D L21^T, lower triangle: U is r x r, L21 the last r rows of the factored m x width block.
void subtractProduct(double* U, int r, const double* F, int m, int width);

}  // namespace pfem
