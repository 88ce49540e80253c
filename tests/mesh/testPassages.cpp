// Points that pass through faces while both move: what is found by boxes is what looking at all faces finds.

#include "mesh/passages.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace pfem;

namespace {

/// Faces at random that move and turn a little, and points that fly among them.
template <int Dim>
void findsWhatAllFacesGive() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-1, 1), step(-0.2, 0.2);
    const auto somewhere = [&] { return Vec<Dim>(Vec<Dim>::NullaryExpr([&] { return place(random); })); };
    const auto shift = [&] { return Vec<Dim>(Vec<Dim>::NullaryExpr([&] { return step(random); })); };
    Points<Dim> from, x;
    NumberedFaces<Dim> faces;
    for (int f = 0; f < 200; ++f) {
        const Vec<Dim> middle = somewhere(), motion = shift();
        Face<Dim> face{};
        for (int& node : face) {
            node = static_cast<int>(from.size());
            from.push_back(middle + shift());
            x.push_back(from.back() + motion + 0.02 * shift());
        }
        faces.emplace_back(7 * f, face);
    }
    const Passages<Dim> all(faces, x, from);
    int passed = 0;
    for (int n = 0; n < 1000; ++n) {
        const Vec<Dim> old = somewhere(), now = old + 2 * shift();
        int expected = -1;
        for (const auto& face : faces)
            expected = std::max(expected, Passages<Dim>({face}, x, from).through(old, now, 1e-3));
        EXPECT_EQ(all.through(old, now, 1e-3), expected) << n;
        passed += expected >= 0;
    }
    EXPECT_GT(passed, 30);
}
TEST(Passages, areThoseOfAllFaces) {
    findsWhatAllFacesGive<2>();
    findsWhatAllFacesGive<3>();
}

/// A floor of length 1 that rises by 0.1; its front is above.
TEST(Passages, seeTheFaceMove) {
    const Points<2> from = {{0, 0}, {1, 0}}, x = {{0, 0.1}, {1, 0.1}};
    const Passages<2> floor({{3, Face<2>{0, 1}}}, x, from);
    EXPECT_EQ(floor.through({0.5, 0.05}, {0.5, 0.05}, 0.01), 3);    // stands still, and the floor comes over it
    EXPECT_EQ(floor.through({0.5, 0.05}, {0.5, 0.095}, 0.01), -1);  // within the slack
    EXPECT_EQ(floor.through({1.5, 0.05}, {1.5, -0.1}, 0.01), -1);   // beside it
    EXPECT_EQ(floor.through({0.5, -0.05}, {0.5, -0.2}, 0.01), -1);  // was behind
    EXPECT_EQ(floor.through({0.9, 0}, {1.1, -0.1}, 0.01), -1);      // stood on it and slid over its end
    EXPECT_EQ(floor.through({0.9, 0}, {0.95, -0.1}, 0.01), 3);
}

}  // namespace
