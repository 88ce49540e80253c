// Volumes of shapes in space: to round-off where they are flat, converging where they are round.

#include "spaceCases.hpp"

#include <fmt/format.h>

#include <numbers>

using namespace pfem;
using namespace pfem::testing;

namespace {

double meshedVolume(const std::string& shape, double h, bool acute = false) {
    const auto result = spaceMeshOf(waterOf(shape, fmt::format("{}", h)));
    expectSound(result.state);
    if (!acute) expectGood(result.state);
    return volumeOf(result.state.nodes.x, result.state.mesh.fluid);
}

TEST(SpaceShapes, FlatOnesHaveTheirVolume) {
    const struct {
        std::string shape;
        double h, volume;
    } shapes[] = {
        {"type box; min (-0.1 0.2 0.3); max (0.4 0.5 1);", 0.1, 0.5 * 0.3 * 0.7},
        {"type extrude; vertices ((0 0) (1 0) (1 0.4) (0.5 0.4) (0.5 1) (0 1)); from -0.2; height 0.5;", 0.15, 0.35},
        {"type extrude; vertices ((0 0) (1 0) (0.5 0.8)); direction (0.2 0.1 0.6);", 0.15, 0.24},
        {"type extrude; vertices ((0 0) (1 0) (0.5 0.8)); height -0.6;", 0.15, 0.24},
        {"type cylinder; point1 (0 0 0); point2 (0.3 0.4 1.2); radius 0.5; segments 6;", 0.2,
         1.3 * 6 * 0.125 * std::sin(std::numbers::pi / 3)},
    };
    for (const auto& s : shapes) EXPECT_NEAR(meshedVolume(s.shape, s.h), s.volume, 1e-12) << s.shape;
}

TEST(SpaceShapes, RoundOnesConverge) {
    const double pi = std::numbers::pi;
    const struct {
        std::string shape;
        double volume;
        bool acute = false;
    } shapes[] = {
        {"type cylinder; point1 (0 0 0); point2 (0 0 0.8); radius 0.5;", 0.25 * pi * 0.8},
        {"type cone; point1 (0 0 0); radius1 0.5; point2 (0 0.9 0); radius2 0.2;", pi * 0.9 / 3 * (0.25 + 0.1 + 0.04)},
        {"type sphere; centre (1 2 3); radius 0.5;", pi / 6},
        {"type extrude; vertices ((0 0) (0.5 0) (-0.5 0)); edges (arc 1 2 (0 0.5)); height 0.6;", pi / 8 * 0.6},
        {"type extrude; vertices ((0.3 0) (0.6 0) (0.6 0.5) (0.3 0.5)); axis z;", pi * (0.36 - 0.09) * 0.5},
        {"type extrude; vertices ((0 0) (0.6 0) (0 0.7)); axis y; angle 270;", 0.75 * pi * 0.36 * 0.7 / 3, true},
        {"type extrude; vertices ((0 0) (0.6 0) (0.6 0.3)); axis x; angle 180;", 0.5 * pi * 0.09 * 0.6 / 3, true},
    };
    for (const auto& s : shapes) {
        const double coarse = meshedVolume(s.shape, 0.16, s.acute) / s.volume - 1,
                     fine = meshedVolume(s.shape, 0.08, s.acute) / s.volume - 1;
        EXPECT_LT(coarse, 0) << s.shape;
        EXPECT_GT(coarse, -0.08) << s.shape;
        EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse)) << s.shape << " " << fine << " " << coarse;
    }
}

TEST(SpaceShapes, CutAndJoined) {
    const auto volume = [](const std::string& more) {
        const auto result = spaceMeshOf(
            "meshSize 0.1; geometry { a { type box; min (0 0 0); max (1 1 1); } b { type box; min (0.5 0.5 0.5); max "
            "(1.5 1.5 "
            "1.5); } c { type box; min (1 0 0); max (1.5 1 1); } } bodies { w { type fluid; material water; " +
            more + " } }");
        expectSound(result.state);
        return volumeOf(result.state.nodes.x, result.state.mesh.fluid);
    };
    EXPECT_NEAR(volume("geometry a; subtract b;"), 0.875, 1e-12);
    EXPECT_NEAR(volume("geometry a; intersect (b);"), 0.125, 1e-12);
    EXPECT_NEAR(volume("geometry (a b);"), 1.875, 1e-12);
    EXPECT_NEAR(volume("geometry (a c);"), 1.5, 1e-12);  // no face is left between them
}

}  // namespace
