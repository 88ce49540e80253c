// A picture of a small state: the right colours at known places, sizes, and what is refused.

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "picture/colourMap.hpp"
#include "picture/sheet.hpp"

using namespace pfem;

namespace {

/// Unit square of fluid with p = 10 x; beside it a solid triangle, above it one drop of area 0.01.
State<2> sample() {
    State<2> state;
    const std::vector<Vec<2>> x{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.5, 0}, {2, 0}, {2, 1}, {0.5, 1.5}};
    state.nodes.resize(static_cast<int>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
        state.nodes.x[i] = x[i];
        state.nodes.p[i] = 10 * x[i][0];
    }
    state.nodes.dropVolume[7] = 0.01;
    state.mesh.fluid = {{{0, 1, 2}, {0, 2, 3}}, {0, 0}};
    state.mesh.solid = {{{4, 5, 6}}, {1}};
    return state;
}

SheetOptions square() {
    SheetOptions options;
    options.width = 800;
    options.range = ValueRange{0, 10};
    options.window = Window{{0, 0}, {2, 2}};
    return options;
}

/// The pixel of a place, from the layout of one panel: margins of 1.4 x 8 at the sides, 2.2 x 8 on top.
Colour colourAt(const Image& image, double x, double y) {
    const double left = 11.2, size = std::floor(800 - 22.4), top = 17.6;
    return image.at(static_cast<int>(left + x / 2 * size), static_cast<int>(top + (1 - y / 2) * size));
}

TEST(Sheet, coloursAtKnownPlaces) {
    const Image image = drawSheet({sample()}, square()).image();
    const ColourMap colours;
    for (const double x : {0.1, 0.5, 0.9}) {
        const Colour seen = colourAt(image, x, 0.5), expected = colours(x);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 3) << x;
    }
    EXPECT_EQ(colourAt(image, 1.2, 0.5), white);
    EXPECT_NE(colourAt(image, 1.85, 0.3), white);  // the solid
    EXPECT_NE(colourAt(image, 0.5, 1.5), white);   // the drop, radius 0.056
    EXPECT_NE(colourAt(image, 0.54, 1.5), white);
    EXPECT_EQ(colourAt(image, 0.58, 1.5), white);
}

TEST(Sheet, solidsHaveTheirOwnFields) {
    State<2> state = sample();
    for (auto& sigma : state.nodes.sigma) sigma = Stress<2>(3, 0, 0, 0);
    EXPECT_DOUBLE_EQ(vonMises<2>(state.nodes.sigma[4]), 3);
    SheetOptions options = square();
    options.field = "vonMises";
    const Image image = drawSheet({state}, options).image();
    const Colour seen = colourAt(image, 1.85, 0.3), expected = ColourMap()(0.3);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 1);
    EXPECT_EQ(colourAt(image, 0.2, 0.5), colourAt(image, 0.8, 0.5));  // the fluid is plain
}

TEST(Sheet, panelsInColumns) {
    SheetOptions options = square();
    const Image one = drawSheet({sample()}, options).image();
    const Image three = drawSheet({sample(), sample(), sample()}, options).image();
    EXPECT_EQ(one.width, 800);
    EXPECT_EQ(three.width, 800);
    EXPECT_LT(three.height, one.height);
    options.columns = 1;
    EXPECT_GT(drawSheet({sample(), sample(), sample()}, options).height(), 2 * one.height);
}

TEST(Sheet, defaultsShowEverything) {
    const Image image = drawSheet({sample()}, SheetOptions{}).image();
    EXPECT_EQ(image.width, 1600);
    EXPECT_GT(image.height, 700);
}

TEST(Sheet, refusals) {
    SheetOptions options = square();
    EXPECT_THROW(drawSheet(std::vector<State<2>>{}, options), UserError);
    EXPECT_THROW(drawSheet({State<2>{}}, SheetOptions{}), UserError);
    options.field = "pressure";
    EXPECT_THROW(drawSheet({sample()}, options), UserError);
    options = square();
    options.columns = 90;
    EXPECT_THROW(drawSheet(std::vector<State<2>>(90, sample()), options), UserError);
    options = square();
    options.window = Window{{0, 0}, {1e-6, 1}};
    EXPECT_THROW(drawSheet({sample()}, options), UserError);
}

TEST(Sheet, pathsInsteadOfPixels) {
    SheetOptions options = square();
    options.format = PictureFormat::svg;
    const std::string text = drawSheet({sample()}, options).file();
    EXPECT_NE(text.find("</svg>"), std::string::npos);
    EXPECT_NE(text.find("<path"), std::string::npos);
    EXPECT_EQ(text.find("<image"), std::string::npos);  // nothing was turned to pixels
}

TEST(Png, hasItsPixels) {
    const std::string bytes = pngOf(Image(7, 5, {10, 20, 30}));
    EXPECT_EQ(bytes.substr(1, 3), "PNG");
    EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\7\0\0\0\5", 8));  // width and height
}

}  // namespace
