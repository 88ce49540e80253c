// Pictures in space: silhouettes, light, cuts, what hides what, the camera's words.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.hpp"
#include "picture/colourMap.hpp"
#include "picture/render.hpp"
#include "picture/sheet.hpp"
#include "spaceSamples.hpp"

using namespace pfem;

namespace {

constexpr double pi = 3.141592653589793;

/// One body about the origin, 100 pixels per metre, the origin in the middle of 400 x 400 pixels.
struct Studio {
    PanelStyle<3> style;
    SpaceOptions options;

    Studio() {
        style.field = &pictureField<3>("none");
        style.colourOf = [](double f) { return ColourMap()(f); };
    }
    Camera camera() const { return {options.view, Vec<3>::Zero(), 2}; }
    Scene scene(const State<3>& state) const { return makeScene(state, style, options, camera()); }
    Image image(const Scene& scene) const {
        return render(scene, camera(), {400, 400, {200, 200}, 100}, style.colourOf);
    }

    /// [m2] of the picture that is not white.
    double silhouette(const State<3>& state) const {
        Scene black = scene(state);
        for (Body* body : {&black.water, &black.solid}) {
            body->coloured = false;
            body->plain = pfem::black;
            body->strokes.clear();
        }
        double sum = 0;
        for (const Colour& pixel : image(black).pixels) sum += 1 - pixel[0] / 255.0;
        return sum / 1e4;
    }
};

State<3> box(const Vec<3>& low, const Vec<3>& high) {
    State<3> state;
    addBox(state, state.mesh.fluid, low, high);
    return state;
}

TEST(SpaceSheet, silhouetteOfABox) {
    Studio studio;
    for (const Vec<3>& d : {Vec<3>(1, -2, 0.8), Vec<3>(0, -1, 0), Vec<3>(-1, 1, -3), Vec<3>(0, 0, 1)}) {
        studio.options.view.direction = d;
        const Vec<3> u = d.normalized().cwiseAbs();
        const double exact = u[0] * 0.8 * 1.2 + u[1] * 1.6 * 1.2 + u[2] * 1.6 * 0.8;  // faces by their cosines
        EXPECT_NEAR(studio.silhouette(box({-0.8, -0.4, -0.6}, {0.8, 0.4, 0.6})), exact, 0.005 * exact) << d.transpose();
    }
}

// The eye at D = 2/sin(15 degrees) sees the circle r D/sqrt(D^2 - r^2) at the scale of the centre.
TEST(SpaceSheet, silhouetteOfABall) {
    Studio studio;
    const State<3> state = ball(1.5, 4);
    EXPECT_NEAR(studio.silhouette(state), pi * 2.25, 0.01 * pi * 2.25);
    studio.options.view.angle = 30;
    const double D = 2 / std::sin(pi / 12), exact = pi * 2.25 * D * D / (D * D - 2.25);
    EXPECT_NEAR(studio.silhouette(state), exact, 0.01 * exact);
}

TEST(SpaceSheet, aDropHasItsVolume) {
    State<3> state;
    state.nodes.resize(1);
    state.nodes.dropVolume[0] = 4.0 / 3 * pi;
    Studio studio;
    EXPECT_NEAR(studio.silhouette(state), pi, 0.01 * pi);
    studio.options.plane = CuttingPlane{{0, 0, 1}, -Vec<3>::UnitZ()};
    EXPECT_EQ(studio.silhouette(state), 0);
}

TEST(SpaceSheet, lightFromTheUpperLeft) {
    const Studio studio;
    const Image image = studio.image(studio.scene(ball(1.5, 3)));
    EXPECT_GT(image.at(150, 120)[2], image.at(200, 200)[2] + 2);
    EXPECT_GT(image.at(200, 200)[2], image.at(270, 290)[2] + 40);
    int largest = 0, step = 0;  // no facets: the light changes little from pixel to pixel
    for (int x = 121; x < 280; ++x) {
        step = std::max(step, std::abs(image.at(x, 200)[2] - image.at(x - 1, 200)[2]));
        largest = std::max<int>(largest, image.at(x, 200)[2]);
    }
    EXPECT_LE(step, 4);
    EXPECT_LE(largest, 208);  // never brighter than the colour itself
}

TEST(SpaceSheet, theCutShowsTheField) {
    Studio studio;
    studio.style.field = &pictureField<3>("p");
    studio.style.range = {-10, 10};
    studio.options.view.direction = {0, -1, 0};
    studio.options.plane = CuttingPlane{{0, 0.1, 0}, -Vec<3>::UnitY()};
    const State<3> state = box({-1, -1, -1}, {1, 1, 1});
    const Image image = studio.image(studio.scene(state));
    for (const double x : {-0.9, -0.3, 0.2, 0.7}) {
        const Colour seen = image.at(static_cast<int>(200 + 100 * x), 170), wanted = ColourMap()(0.5 + 0.5 * x);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], wanted[c], 3) << x;
    }
    studio.options.plane->normal = Vec<3>::UnitX();
    studio.options.plane->point = {0.5, 0, 0};
    EXPECT_NEAR(studio.silhouette(state), 1.5 * 2, 0.01 * 3);
}

TEST(SpaceSheet, theNearBodyHidesTheFarOne) {
    State<3> state = box({-0.5, -1, -0.5}, {0.5, -0.5, 0.5});
    addBox(state, state.mesh.solid, {-1, 0.5, -1}, {1, 1, 1});
    Studio studio;
    studio.options.view.direction = {0, -1, 0};
    const Image front = studio.image(studio.scene(state));
    EXPECT_GT(front.at(200, 200)[2], front.at(200, 200)[0]);  // water is blue
    EXPECT_LT(front.at(280, 200)[2], front.at(280, 200)[0]);  // the solid beside it is not
    studio.options.view.direction = {0, 1, 0};
    const Image back = studio.image(studio.scene(state));
    EXPECT_LT(back.at(200, 200)[2], back.at(200, 200)[0]);

    studio.options.view.direction = {0, -1, 0};
    studio.options.opacity = 0.5;  // the mean of both
    const Image half = studio.image(studio.scene(state));
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(half.at(200, 200)[c], 0.5 * (front.at(200, 200)[c] + front.at(280, 200)[c]), 1);
}

TEST(SpaceSheet, wallsAreSeenFromTheirInside) {
    State<3> state;
    for (const Vec<3>& x : {Vec<3>(-1, 1, -1), Vec<3>(1, 1, -1), Vec<3>(1, 1, 1), Vec<3>(-1, 1, 1)}) addNode(state, x);
    state.mesh.patches = {{"pane", {{0, 2, 1}, {0, 3, 2}}}};  // fluid at smaller y
    Studio studio;
    const auto middle = [&](double y, WallLook look) {
        studio.options.view.direction = {0, y, 0};
        studio.options.walls = look;
        return studio.image(studio.scene(state)).at(190, 220);
    };
    EXPECT_NE(middle(-1, WallLook::inside), white);
    EXPECT_EQ(middle(1, WallLook::inside), white);
    EXPECT_EQ(middle(-1, WallLook::outline), white);
    EXPECT_NE(middle(1, WallLook::translucent), white);
    EXPECT_EQ(middle(1, WallLook::translucent), middle(-1, WallLook::translucent));
    const Image image = studio.image(studio.scene(state));
    EXPECT_LT(image.at(100, 200)[0] + 20, image.at(190, 220)[0]);  // its edge
}

TEST(SpaceSheet, theCameraHasItsWords) {
    const Vec<3> z = Vec<3>::UnitZ(), y = Vec<3>::UnitY();
    EXPECT_EQ(upwards({0, 0, -9.81}), z);
    EXPECT_EQ(upwards({0.5, -9.81, 0}), y);
    EXPECT_EQ(upwards(Vec<3>::Zero()), z);
    EXPECT_EQ(viewDirection("front", z), -y);
    EXPECT_EQ(viewDirection("front", y), z);
    EXPECT_EQ(viewDirection("right", y), Vec<3>::UnitX());
    EXPECT_THROW(viewDirection("above", z), UserError);
    const Camera top({z, z}, Vec<3>::Zero(), 1);
    EXPECT_LT((top.see({0.3, 0.2, 0}).place - Vec<2>(0.3, 0.2)).norm(), 1e-14);
    const Camera front({-y, z}, Vec<3>::Zero(), 1);
    EXPECT_LT((front.see({0.3, 0.2, 0.1}).place - Vec<2>(0.3, 0.1)).norm(), 1e-14);
    EXPECT_LT(front.see({0, -0.5, 0}).depth, front.see({0, 0.5, 0}).depth);
}

TEST(SpaceSheet, sheetsAreTheSameEveryTime) {
    State<3> state = box({0, 0, 0}, {1, 1, 1});
    SheetOptions options;
    options.width = 300;
    EXPECT_EQ(drawSheet({state}, options).file(), drawSheet({state}, options).file());
    const std::string wet = drawSheet({state}, options).file();
    addBox(state, state.mesh.solid, {1, 0, 0}, {1.5, 1, 1});
    EXPECT_NE(drawSheet({state}, options).file(), wet);
    options.format = PictureFormat::svg;
    EXPECT_NE(drawSheet({state}, options).file().find("<image"), std::string::npos);
    EXPECT_THROW(drawSheet(std::vector<State<3>>{}, options), UserError);
    EXPECT_THROW(drawSheet({State<3>{}}, options), UserError);
    options.field = "curl";
    EXPECT_THROW(drawSheet({state}, options), UserError);
}

TEST(SpaceSheet, stressesOfThreeDimensions) {
    EXPECT_NEAR(vonMises<3>((Stress<3>() << 5, 2, 2, 0, 0, 0).finished()), 3, 1e-14);
    EXPECT_NEAR(vonMises<3>((Stress<3>() << 0, 0, 0, 1, 2, 2).finished()), 3 * std::sqrt(3.0), 1e-14);
    Nodes<3> nodes;
    nodes.resize(1);
    nodes.sigma[0] << 1, 2, 3, 4, 5, 6;
    EXPECT_EQ(pictureField<3>("sigmaxz").value(nodes, 0), 6);
    EXPECT_EQ(pictureField<3>("sigmayz").value(nodes, 0), 5);
    EXPECT_THROW(pictureField<2>("Uz"), UserError);
}

}  // namespace
