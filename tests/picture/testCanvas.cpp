// Pixels and files of the canvas, bands of colour, the colour maps and the numbers on a scale.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "picture/canvas.hpp"
#include "picture/colourMap.hpp"
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
    canvas.triangles({{Vec<2>(2, 2), Vec<2>(18, 2), Vec<2>(2, 18)}}, red);
    const Image image = canvas.image();
    EXPECT_EQ(image.at(4, 4), red);
    EXPECT_EQ(image.at(15, 15), white);
    EXPECT_EQ(image.at(1, 4), white);
    EXPECT_GT(image.at(10, 9)[1], 60);  // on the long edge
    EXPECT_LT(image.at(10, 9)[1], 200);
}

TEST(Canvas, bothOrientationsAreTheSame) {
    Canvas a(12, 12), b(12, 12);
    a.triangles({{Vec<2>(1, 1), Vec<2>(10, 3), Vec<2>(4, 11)}}, red);
    b.triangles({{Vec<2>(4, 11), Vec<2>(10, 3), Vec<2>(1, 1)}}, red);
    EXPECT_EQ(a.image().pixels, b.image().pixels);
}

TEST(Canvas, neighboursLeaveNoGap) {
    Canvas canvas(30, 30);
    const Vec<2> a(1, 1), b(29, 2), c(28, 29), d(2, 27);
    canvas.triangles({{a, b, c}}, red);
    canvas.triangles({{a, c, d}}, red);
    const Image image = canvas.image();
    for (int i = 4; i < 26; ++i) EXPECT_EQ(image.at(i, i), red) << i;
}

TEST(Canvas, valuesAreLinear) {
    Canvas canvas(100, 100);
    const auto grey = [](double f) { return Colour{static_cast<std::uint8_t>(std::lround(200 * f)), 0, 0}; };
    canvas.triangles({{{Vec<2>(0, 0), Vec<2>(100, 0), Vec<2>(0, 100)}, {0, 1, 0}}}, grey);
    const Image image = canvas.image();
    EXPECT_NEAR(image.at(25, 10)[0], 2 * 25.5, 1);
    EXPECT_NEAR(image.at(60, 30)[0], 2 * 60.5, 1);
    EXPECT_EQ(image.at(80, 80), white);
}

TEST(Canvas, shadedNeighboursLeaveNoGap) {
    Canvas canvas(60, 60);
    const Vec<2> a(1, 1), b(59, 2), c(58, 59), d(2, 57), m(31.3, 27.7);
    const auto blue = [](double f) { return Colour{0, 0, static_cast<std::uint8_t>(std::lround(100 + 100 * f))}; };
    canvas.triangles({{{a, b, m}, {0.1, 0.9, 0.3}},
                      {{b, c, m}, {0.9, 0.2, 0.3}},
                      {{c, d, m}, {0.2, 1.4, 0.3}},
                      {{d, a, m}, {1.4, 0.1, 0.3}}},
                     blue);
    const Image image = canvas.image();
    for (int y = 4; y < 55; ++y)
        for (int x = 4; x < 55; ++x) ASSERT_EQ(image.at(x, y)[0], 0) << x << " " << y;  // no white in it
}

TEST(Canvas, nothingOutsideTheClipOrTheCanvas) {
    Canvas canvas(20, 20);
    canvas.clip({5, 5, 10, 10});
    canvas.line({-50, 7}, {70, 7}, 100, red);
    EXPECT_EQ(painted(canvas.image()), 25);
}

TEST(Canvas, brokenTrianglesAreIgnored) {
    Canvas canvas(8, 8);
    canvas.triangles(
        {{Vec<2>(1, 1), Vec<2>(2, 2), Vec<2>(3, 3)}, {Vec<2>(1, 1), Vec<2>(std::nan(""), 2), Vec<2>(3, 5)}}, red);
    EXPECT_EQ(painted(canvas.image()), 0);
    const auto grey = [](double f) { return std::isfinite(f) ? red : Colour{150, 150, 150}; };
    canvas.triangles({{{Vec<2>(0, 0), Vec<2>(8, 0), Vec<2>(0, 8)}, {0, std::nan(""), 1}}}, grey);
    EXPECT_EQ(canvas.image().at(1, 1), (Colour{150, 150, 150}));
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

TEST(Canvas, textHasItsSizeAndItsPlace) {
    Canvas canvas(60, 30);
    EXPECT_EQ(canvas.textWidth("", 10), 0);
    EXPECT_NEAR(canvas.textWidth("00", 10), 2 * canvas.textWidth("0", 10), 1e-6);
    EXPECT_NEAR(canvas.textWidth("H", 20), 2 * canvas.textWidth("H", 10), 0.1);
    canvas.text("H", {50, 25}, 18, Align::right);
    const Image image = canvas.image();
    int top = 30, bottom = 0, left = 60, right = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 60; ++x)
            if (image.at(x, y)[0] < 128) {
                top = std::min(top, y);
                bottom = std::max(bottom, y);
                left = std::min(left, x);
                right = std::max(right, x);
            }
    EXPECT_NEAR(top, 25 - 18, 1);
    EXPECT_NEAR(bottom, 24, 1);
    EXPECT_LE(right, 50);
    EXPECT_GE(left, 50 - canvas.textWidth("H", 18) - 1);
}

TEST(Canvas, filesOfEachFormat) {
    for (const auto& [word, beginning] :
         {std::pair("png", "\x89PNG"), std::pair("svg", "<?xml"), std::pair("pdf", "%PDF-")}) {
        Canvas canvas(40, 30, pictureFormat(word));
        canvas.triangles({{{Vec<2>(2, 2), Vec<2>(18, 2), Vec<2>(2, 18)}, {0, 1, 0.5}}}, [](double) { return red; });
        canvas.text("t = 1 s", {5, 25}, 8);
        EXPECT_EQ(canvas.file().substr(0, std::string(beginning).size()), beginning) << word;
    }
    EXPECT_THROW(pictureFormat("jpg"), UserError);
    EXPECT_THROW(Canvas(40000, 10), UserError);
}

double area(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum;
}

// The share of a triangle with values in a band, when they are linear from 0 at one side to 1 at the corner opposite.
TEST(Bands, haveTheirShareOfTheArea) {
    const auto bands = bandsOf({{{Vec<2>(0, 0), Vec<2>(4, 0), Vec<2>(1, 3)}, {0, 0, 1}}});
    double sum = 0;
    for (int k = 0; k < nBands; ++k) {
        ASSERT_EQ(bands[k].size(), 1u) << k;
        const double low = 1 - double(k) / nBands, high = 1 - double(k + 1) / nBands;
        EXPECT_NEAR(area(bands[k][0]), 6 * (low * low - high * high), 1e-12) << k;
        sum += area(bands[k][0]);
    }
    EXPECT_NEAR(sum, 6, 1e-12);
}

TEST(Bands, endsOfTheScaleAndSingleValues) {
    const std::array<Vec<2>, 3> corners{Vec<2>(0, 0), Vec<2>(2, 0), Vec<2>(0, 2)};
    const auto beyond = bandsOf({{corners, {-5, -4, -3}}, {corners, {2, 2, 2}}, {corners, {0.5, 0.5, 0.5}}});
    EXPECT_NEAR(area(beyond[0].at(0)), 2, 1e-14);
    EXPECT_NEAR(area(beyond[nBands - 1].at(0)), 2, 1e-14);
    EXPECT_NEAR(area(beyond[nBands / 2].at(0)), 2, 1e-14);
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
