// Uniform bins: nothing that is near is missed.

#include "mesh/bins.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace pfem;

namespace {

template <int Dim>
void findsAllThatIsNear() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-3, 2), size(0, 0.4);
    Points<Dim> low, high;
    for (int k = 0; k < 300; ++k) {
        low.push_back(Vec<Dim>::NullaryExpr([&] { return place(random); }));
        high.push_back(low.back() + Vec<Dim>::NullaryExpr([&] { return size(random); }));
    }
    Bins<Dim> bins(low, 0.7);  // some boxes reach beyond the whole one
    for (int k = 0; k < 300; ++k) bins.add(k, low[k], high[k]);
    for (int n = 0; n < 200; ++n) {
        const Vec<Dim> x = Vec<Dim>::NullaryExpr([&] { return 1.3 * place(random); });
        const double radius = size(random);
        std::set<int> found;
        bins.forEachNear(x, radius, [&](int k) { found.insert(k); });
        for (int k = 0; k < 300; ++k) {
            const Vec<Dim> away = (low[k] - x).cwiseMax(x - high[k]).cwiseMax(0);
            if (away.norm() <= radius) {
                EXPECT_EQ(found.count(k), 1u) << k;
            }
        }
        EXPECT_LT(found.size(), 150u);  // and far less than everything
    }
}
TEST(Bins, findAllThatIsNear) {
    findsAllThatIsNear<2>();
    findsAllThatIsNear<3>();
}

TEST(Bins, keepTheOrderAndStopWhenTold) {
    Bins<2> bins({0, 0}, {10, 10}, 1);
    for (const int k : {7, 3, 5}) bins.add(k, {2.5, 2.5}, {2.6, 2.6});
    bins.add(9, {0, 0}, {10, 10});
    std::vector<int> seen;
    bins.parallelFor({2.1, 2.1}, {2.2, 2.2}, [&](int k) { seen.push_back(k); });
    EXPECT_EQ(seen, (std::vector<int>{7, 3, 5, 9}));
    seen.clear();
    EXPECT_TRUE(bins.any({2.1, 2.1}, {2.2, 2.2}, [&](int k) {
        seen.push_back(k);
        return k == 3;
    }));
    EXPECT_EQ(seen, (std::vector<int>{7, 3}));
    EXPECT_FALSE(bins.any({2.1, 2.1}, {2.2, 2.2}, [](int) { return false; }));
}

TEST(Bins, noPlacesNoWidthAndTooManyBins) {
    Bins<2> none(Points<2>{}, 1);
    none.parallelFor({-1, -1}, {1, 1}, [](int) { FAIL(); });
    Bins<2> single(Points<2>{{1, 1}}, 0);
    single.add(4, {1, 1}, {1, 1});
    int count = 0;
    single.parallelFor({0, 0}, {2, 2}, [&](int k) { count += k == 4; });
    EXPECT_EQ(count, 1);
    Bins<2> many(Points<2>{{0, 0}, {1e9, 1}}, 1e-3);  // wider ones than asked for
    many.add(1, {5e8, 0}, {5e8, 1});
    count = 0;
    many.forEachNear({5e8, 0}, 1, [&](int k) { count += k; });
    EXPECT_EQ(count, 1);
}

}  // namespace
