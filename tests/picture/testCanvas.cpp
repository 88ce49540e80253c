// Pixels of the rasteriser, the colour maps, the font and the numbers on a scale.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "picture/canvas.hpp"
#include "picture/colourMap.hpp"
#include "picture/strokeFont.hpp"
#include "picture/ticks.hpp"

using namespace pfem;

namespace {

constexpr Colour red{255, 0, 0};

int painted(const Image& image) {
    int count = 0;
    for (const auto& pixel : image.pixels) count += pixel != white;
    return count;
}

TEST(Canvas, triangleCoversItsPixelsAndHalvesItsEdges) {
    Canvas canvas(20, 20);
    canvas.triangle({Vec<2>(2, 2), Vec<2>(18, 2), Vec<2>(2, 18)}, red);
    const Image image = canvas.image();
    EXPECT_EQ(image.at(4, 4), red);
    EXPECT_EQ(image.at(15, 15), white);
    EXPECT_EQ(image.at(1, 4), white);
    EXPECT_GT(image.at(10, 9)[1], 60);  // on the long edge
    EXPECT_LT(image.at(10, 9)[1], 200);
}

TEST(Canvas, bothOrientationsAreTheSame) {
    Canvas a(12, 12), b(12, 12);
    a.triangle({Vec<2>(1, 1), Vec<2>(10, 3), Vec<2>(4, 11)}, red);
    b.triangle({Vec<2>(4, 11), Vec<2>(10, 3), Vec<2>(1, 1)}, red);
    EXPECT_EQ(a.image().pixels, b.image().pixels);
}

TEST(Canvas, neighboursLeaveNoGap) {
    Canvas canvas(30, 30);
    const Vec<2> a(1, 1), b(29, 2), c(28, 29), d(2, 27);
    canvas.triangle({a, b, c}, red);
    canvas.triangle({a, c, d}, red);
    const Image image = canvas.image();
    for (int i = 4; i < 26; ++i) EXPECT_EQ(image.at(i, i), red) << i;
}

TEST(Canvas, valuesAreLinear) {
    Canvas canvas(100, 100);
    const auto grey = [](double v) { return Colour{static_cast<std::uint8_t>(std::lround(v)), 0, 0}; };
    canvas.triangle({Vec<2>(0, 0), Vec<2>(100, 0), Vec<2>(0, 100)}, {0, 200, 0}, grey);
    const Image image = canvas.image();
    EXPECT_NEAR(image.at(25, 10)[0], 2 * 25.5, 1);
    EXPECT_NEAR(image.at(60, 30)[0], 2 * 60.5, 1);
}

TEST(Canvas, nothingOutsideTheClipOrTheCanvas) {
    Canvas canvas(20, 20);
    canvas.clip({5, 5, 10, 10});
    canvas.line({-50, 7}, {70, 7}, 100, red);
    EXPECT_EQ(painted(canvas.image()), 25);
}

TEST(Canvas, brokenTrianglesAreIgnored) {
    Canvas canvas(8, 8);
    canvas.triangle({Vec<2>(1, 1), Vec<2>(2, 2), Vec<2>(3, 3)}, red);
    canvas.triangle({Vec<2>(1, 1), Vec<2>(std::nan(""), 2), Vec<2>(3, 5)}, red);
    EXPECT_EQ(painted(canvas.image()), 0);
}

TEST(Canvas, discHasItsArea) {
    Canvas canvas(40, 40);
    canvas.disc({20, 20}, 10, black);
    double area = 0;
    for (const auto& pixel : canvas.image().pixels) area += 1 - pixel[0] / 255.0;
    EXPECT_NEAR(area, 3.14159 * 100, 2);
}

TEST(ColourMap, endsBeyondAndNotANumber) {
    const ColourMap viridis("viridis");
    EXPECT_EQ(viridis(0), (Colour{68, 1, 84}));
    EXPECT_EQ(viridis(1), (Colour{253, 231, 37}));
    EXPECT_EQ(viridis(-3), viridis(0));
    EXPECT_EQ(viridis(7), viridis(1));
    EXPECT_EQ(viridis(std::nan("")), (Colour{150, 150, 150}));
    try {
        ColourMap("viridiss");
        FAIL();
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("coolWarm"), std::string::npos) << error.what();
    }
}

TEST(ColourMap, viridisBecomesBrighterAllTheWay) {
    const ColourMap viridis;
    double before = -1;
    for (int i = 0; i <= 50; ++i) {
        const Colour c = viridis(i / 50.0);
        const double brightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
        EXPECT_GT(brightness, before);
        before = brightness;
    }
}

TEST(StrokeFont, widthsAndAlignment) {
    EXPECT_EQ(textWidth("", 10), 0);
    EXPECT_GT(textWidth("00", 10), 2 * textWidth("0", 10));
    Canvas canvas(60, 30);
    drawText(canvas, "8", {50, 25}, 18, Align::right);
    const Image image = canvas.image();
    EXPECT_GT(painted(image), 20);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 37; ++x) EXPECT_EQ(image.at(x, y), white);
        for (int x = 53; x < 60; ++x) EXPECT_EQ(image.at(x, y), white);
    }
}

TEST(Ticks, roundNumbers) {
    EXPECT_EQ(roundTicks(0, 3000, 6), (std::vector<double>{0, 500, 1000, 1500, 2000, 2500, 3000}));
    const auto ticks = roundTicks(-0.013, 0.052, 6);
    EXPECT_NEAR(ticks.front(), 0, 1e-15);
    EXPECT_NEAR(ticks.back(), 0.04, 1e-12);
    EXPECT_EQ(roundTicks(1, 1, 6).size(), 1u);
    EXPECT_EQ(roundTicks(0, std::numeric_limits<double>::infinity(), 6).size(), 1u);
    EXPECT_EQ(tickLabel(-1e-18, 1), "0");
    EXPECT_EQ(tickLabel(0.30000000000000004, 1), "0.3");
}

}  // namespace
