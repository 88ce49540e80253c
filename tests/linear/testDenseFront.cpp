// Dense fronts by tiles: the same bits as column after column.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "linear/denseFront.hpp"

using namespace pfem;

namespace {

/// A front m x width with strong pivots of both signs, and its remainder.
template <class Real>
struct Sample {
    int m, width;
    std::vector<Real> F, U;
    int left() const { return m - width; }
};

template <class Real>
Sample<Real> sample(int m, int width) {
    std::mt19937 random(3);
    std::uniform_real_distribution<Real> value(-1, 1);
    Sample<Real> s{m, width, std::vector<Real>(static_cast<std::size_t>(m) * width), {}};
    s.U.resize(packedSize(s.left()));
    for (Real& f : s.F) f = value(random);
    for (Real& u : s.U) u = value(random);
    for (int k = 0; k < width; ++k) s.F[static_cast<std::size_t>(k) * m + k] = static_cast<Real>(k % 3 ? m : -m);
    return s;
}

/// L and D, one column after the other; then the remainder, four columns at a time.
template <class Real>
Sample<Real> byColumns(Sample<Real> s) {
    const auto F = [&](int i, int k) -> Real& { return s.F[static_cast<std::size_t>(k) * s.m + i]; };
    for (int k = 0; k < s.width; ++k) {
        const Real inverse = 1 / F(k, k);
        for (int j = k + 1; j < s.width; ++j)
            for (int i = j; i < s.m; ++i) F(i, j) -= F(j, k) * inverse * F(i, k);
        for (int i = k + 1; i < s.m; ++i) F(i, k) *= inverse;
    }
    for (int j = 0; j < s.left(); ++j)
        for (int i = j; i < s.left(); ++i) {
            Real& u = s.U[packedColumn(j, s.left()) + i];
            const auto term = [&](int k) { return F(k, k) * F(s.width + j, k) * F(s.width + i, k); };
            int k = 0;
            for (; k + 4 <= s.width; k += 4) u -= (term(k) + term(k + 1)) + (term(k + 2) + term(k + 3));
            for (; k < s.width; ++k) u -= term(k);
        }
    return s;
}

/// own = L11^{-1} own, below = L21 own, four columns at a time.
template <class Stored>
void eliminatePlainly(const std::vector<Stored>& L, int m, std::vector<double>& own, std::vector<double>& below) {
    const int width = static_cast<int>(own.size()), r = m - width;
    const auto at = [&](int i, int k) { return static_cast<double>(L[static_cast<std::size_t>(k) * m + i]); };
    for (int k = 0; k < width; ++k)
        for (int i = k + 1; i < width; ++i) own[i] -= at(i, k) * own[k];
    for (int i = 0; i < r; ++i) {
        const auto term = [&](int k) { return at(width + i, k) * own[k]; };
        int k = 0;
        for (; k + 4 <= width; k += 4) below[i] += (term(k) + term(k + 1)) + (term(k + 2) + term(k + 3));
        for (; k < width; ++k) below[i] += term(k);
    }
}

/// own = L11^{-T} (D^{-1} own - L21^T below), eight sums side by side.
template <class Stored>
void substitutePlainly(const std::vector<Stored>& L, int m, const std::vector<double>& below,
                       std::vector<double>& own) {
    const int width = static_cast<int>(own.size()), r = m - width;
    const auto at = [&](int i, int k) { return static_cast<double>(L[static_cast<std::size_t>(k) * m + i]); };
    for (int k = width - 1; k >= 0; --k) {
        double sums[8] = {}, sum = 0;
        for (int i = 0; i < r; ++i) sums[i % 8] += at(width + i, k) * below[i];
        for (const double part : sums) sum += part;
        for (int i = k + 1; i < width; ++i) sum += at(i, k) * own[i];
        own[k] = own[k] / at(k, k) - sum;
    }
}

/// Both with the registers of this processor (AVX2 or AVX-512 where it has them) and by plain loops.
template <class Stored>
void expectBitsOfPlainLoops(const Sample<double>& s) {
    const std::vector<Stored> L(s.F.begin(), s.F.end());
    std::vector<double> own(s.width), below(s.left(), 0.0);
    for (int k = 0; k < s.width; ++k) own[k] = std::sin(k + 1.0);
    std::vector<double> plainOwn = own, plainBelow = below;
    eliminateColumns(L.data(), s.m, s.width, own.data(), below.data());
    eliminatePlainly(L, s.m, plainOwn, plainBelow);
    EXPECT_EQ(own, plainOwn);
    EXPECT_EQ(below, plainBelow);
    substituteColumns(L.data(), s.m, s.width, below.data(), own.data());
    substitutePlainly(L, s.m, plainBelow, plainOwn);
    EXPECT_EQ(own, plainOwn);
}

/// Both kernels of a factor, of m rows.
template <class Real>
void expectBitsOfColumns(int m, int width) {
    Sample<Real> s = sample<Real>(m, width);
    const Sample<Real> expected = byColumns(s);
    ASSERT_TRUE(factorColumns(s.F.data(), s.m, width));
    subtractProduct(s.U.data(), s.left(), s.F.data(), s.m, width);
    for (int k = 0; k < width; ++k)
        for (int i = k; i < s.m; ++i) {
            const std::size_t at = static_cast<std::size_t>(k) * s.m + i;
            ASSERT_EQ(s.F[at], expected.F[at]) << "row " << i << ", column " << k;
        }
    EXPECT_EQ(s.U, expected.U);
}

}  // namespace

class DenseFront : public testing::TestWithParam<std::tuple<int, int>> {};

/// Widths around that of a panel, rows around those of a tile; a tile at the edge, a rest of products below four.
TEST_P(DenseFront, tilesGiveTheBitsOfColumns) {
    const auto [left, width] = GetParam();
    expectBitsOfColumns<double>(left + width, width);
    expectBitsOfColumns<float>(left + width, width);
}

/// Registers of any width give the same bits: what is computed does not depend on the machine.
TEST_P(DenseFront, substitutionsGiveTheBitsOfPlainLoops) {
    const auto [left, width] = GetParam();
    Sample<double> s = sample<double>(left + width, width);
    ASSERT_TRUE(factorColumns(s.F.data(), s.m, width));
    expectBitsOfPlainLoops<float>(s);
    expectBitsOfPlainLoops<double>(s);
}

INSTANTIATE_TEST_SUITE_P(Sizes, DenseFront,
                         testing::Combine(testing::Values(0, 5, 60, 160, 399, 400, 437),
                                          testing::Values(1, 31, 63, 64, 97, 131)));

TEST(DenseFront, saysThatAPivotVanishes) {
    Sample<double> s = sample<double>(90, 80);
    for (int i = 0; i < s.m; ++i) s.F[static_cast<std::size_t>(70) * s.m + i] = 0;
    for (int k = 0; k < 70; ++k) s.F[static_cast<std::size_t>(k) * s.m + 70] = 0;
    EXPECT_FALSE(factorColumns(s.F.data(), s.m, s.width));
}
