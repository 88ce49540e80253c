// Slivers: tetrahedra whose nodes lie nearly in a plane though none is near another.

#include <gtest/gtest.h>

#include "mesh/simplex.hpp"

using namespace pfem;

namespace {

/// Four nodes near a square of side 1, every other one `height` above it: Q = |e|^(2/3) max |grad N|^2 grows as the
/// -4/3rd power of it.
Points<3> nearASquare(double height) { return {{0, 0, 0}, {1, 0, height}, {1, 1, 0}, {0, 1, height}}; }

constexpr Simplex<3> sliver{0, 1, 2, 3};

double quality(const Points<3>& x, const Simplex<3>& s) {
    const auto g = simplexGeometry<3>(x, s);
    double steepest = 0;
    for (const auto& gradN : g.gradN) steepest = std::max(steepest, gradN.squaredNorm());
    return std::pow(std::abs(g.measure), 2.0 / 3) * steepest;
}

TEST(Sliver, goodCellsKeepAll) {
    const Points<3> regular{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
        cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
    EXPECT_NEAR(quality(regular, {0, 1, 2, 3}), 0.36, 0.005);
    for (const auto& x : {regular, cube}) {
        const Simplex<3> cell =
            simplexMeasure<3>(x, {0, 1, 2, 3}) > 0 ? Simplex<3>{0, 1, 2, 3} : Simplex<3>{1, 0, 2, 3};
        EXPECT_EQ(sliverFactor<3>(simplexGeometry<3>(x, cell)), 1);
        EXPECT_FALSE(isSliver<3>(x, cell));
    }
}

// The factor depends on the shape alone, leaves the limit without a jump and makes |e| |grad N|^2 vanish with the
// height: |e| ~ height, |grad N|^2 ~ height^-2, factor ~ height^2.
TEST(Sliver, itsTermsVanishWithItsHeight) {
    const auto term = [](double height, double size) {
        Points<3> x = nearASquare(height);
        for (auto& place : x) place *= size;
        const auto g = simplexGeometry<3>(x, sliver);
        EXPECT_GT(g.measure, 0);
        return std::pair(sliverFactor<3>(g), sliverFactor<3>(g) * g.measure * g.gradN[0].squaredNorm() / size);
    };
    EXPECT_NEAR(term(1e-3, 1).first, term(1e-3, 7).first, 1e-12);
    EXPECT_NEAR(term(1e-3, 1).second, term(1e-3, 7).second, 1e-12);
    EXPECT_NEAR(term(1e-4, 1).second / term(1e-3, 1).second, 0.1, 1e-3);
    EXPECT_NEAR(term(1e-8, 1).second / term(1e-3, 1).second, 1e-5, 1e-7);
    double low = 1e-3, high = 1;  // the height where Q is 4
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (quality(nearASquare(middle), sliver) > 4 ? low : high) = middle;
    }
    EXPECT_NEAR(term(0.999 * low, 1).first, 1, 5e-3);
    EXPECT_LT(term(0.999 * low, 1).first, 1);
    EXPECT_EQ(term(1.001 * low, 1).first, 1);
    EXPECT_TRUE(isSliver<3>(nearASquare(0.99 * low), sliver));
    EXPECT_FALSE(isSliver<3>(nearASquare(1.01 * low), sliver));
}

TEST(Sliver, flatAndInvertedCellsAre) {
    EXPECT_TRUE(isSliver<3>(nearASquare(0), sliver));
    EXPECT_TRUE(isSliver<3>(nearASquare(-1), sliver));
    EXPECT_TRUE(std::isfinite(sliverFactor<3>(simplexGeometry<3>(nearASquare(0), sliver))));
}

TEST(Sliver, thereAreNoneInThePlane) {
    const Points<2> needle{{0, 0}, {1, 0}, {0.5, 1e-9}};
    EXPECT_EQ(sliverFactor<2>(simplexGeometry<2>(needle, {0, 1, 2})), 1);
    EXPECT_FALSE(isSliver<2>(needle, {0, 1, 2}));
}

}  // namespace
