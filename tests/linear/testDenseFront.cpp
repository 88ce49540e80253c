// Dense fronts by tiles: the same bits as column after column.

#include <gtest/gtest.h>

#include <random>
#include <tuple>
#include <vector>

#include "linear/denseFront.hpp"

using namespace pfem;

namespace {

/// A front m x width with strong pivots of both signs, and its remainder.
struct Sample {
    int m, width;
    std::vector<double> F, U;
    int left() const { return m - width; }
};

Sample sample(int m, int width) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-1, 1);
    Sample s{m, width, std::vector<double>(static_cast<std::size_t>(m) * width), {}};
    s.U.resize(packedSize(s.left()));
    for (double& f : s.F) f = value(random);
    for (double& u : s.U) u = value(random);
    for (int k = 0; k < width; ++k) s.F[static_cast<std::size_t>(k) * m + k] = k % 3 ? m : -m;
    return s;
}

/// L and D, one column after the other; then the remainder, four columns at a time.
Sample byColumns(Sample s) {
    const auto F = [&](int i, int k) -> double& { return s.F[static_cast<std::size_t>(k) * s.m + i]; };
    for (int k = 0; k < s.width; ++k) {
        const double inverse = 1 / F(k, k);
        for (int j = k + 1; j < s.width; ++j)
            for (int i = j; i < s.m; ++i) F(i, j) -= F(j, k) * inverse * F(i, k);
        for (int i = k + 1; i < s.m; ++i) F(i, k) *= inverse;
    }
    for (int j = 0; j < s.left(); ++j)
        for (int i = j; i < s.left(); ++i) {
            double& u = s.U[packedColumn(j, s.left()) + i];
            const auto term = [&](int k) { return F(k, k) * F(s.width + j, k) * F(s.width + i, k); };
            int k = 0;
            for (; k + 4 <= s.width; k += 4) u -= (term(k) + term(k + 1)) + (term(k + 2) + term(k + 3));
            for (; k < s.width; ++k) u -= term(k);
        }
    return s;
}

}  // namespace

class DenseFront : public testing::TestWithParam<std::tuple<int, int>> {};

/// Widths around that of a panel, rows around those of a tile; a tile at the edge, a rest of products below four.
TEST_P(DenseFront, tilesGiveTheBitsOfColumns) {
    const auto [left, width] = GetParam();
    Sample s = sample(left + width, width);
    const Sample expected = byColumns(s);
    ASSERT_TRUE(factorColumns(s.F.data(), s.m, width));
    subtractProduct(s.U.data(), left, s.F.data(), s.m, width);
    for (int k = 0; k < width; ++k)
        for (int i = k; i < s.m; ++i) {
            const std::size_t at = static_cast<std::size_t>(k) * s.m + i;
            ASSERT_EQ(s.F[at], expected.F[at]) << "row " << i << ", column " << k;
        }
    EXPECT_EQ(s.U, expected.U);
}

INSTANTIATE_TEST_SUITE_P(Sizes, DenseFront,
                         testing::Combine(testing::Values(0, 5, 399, 400, 437),
                                          testing::Values(1, 31, 63, 64, 97, 131)));

TEST(DenseFront, saysThatAPivotVanishes) {
    Sample s = sample(90, 80);
    for (int i = 0; i < s.m; ++i) s.F[static_cast<std::size_t>(70) * s.m + i] = 0;
    for (int k = 0; k < 70; ++k) s.F[static_cast<std::size_t>(k) * s.m + 70] = 0;
    EXPECT_FALSE(factorColumns(s.F.data(), s.m, s.width));
}
