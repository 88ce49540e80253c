#include "waves/reflection.hpp"

namespace pfem {

std::optional<Waves> separateWaves(const std::vector<double>& x, const std::vector<std::complex<double>>& A, double k) {
    std::complex<double> along = 0, against = 0, mixed = 0;  // normal equations: [n, mixed; mixed*, n]
    for (std::size_t m = 0; m < x.size(); ++m) {
        const auto turn = std::polar(1.0, k * x[m]);
        along += turn * A[m];
        against += std::conj(turn) * A[m];
        mixed += turn * turn;
    }
    const auto n = static_cast<double>(x.size());
    const double determinant = n * n - std::norm(mixed);
    if (determinant < 0.1 * n * n) return {};  // of two gauges: sin^2 k (x_2 - x_1)
    return Waves{(n * along - mixed * against) / determinant, (n * against - std::conj(mixed) * along) / determinant};
}

}  // namespace pfem
