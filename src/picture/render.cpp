#include "picture/render.hpp"

#include <algorithm>
#include <cmath>

#include "picture/renderer.hpp"

namespace pfem {

namespace {

constexpr double paneOpacity = 0.12;  // of each translucent wall
constexpr Colour paneColour{110, 120, 130};

Colour mixed(Colour below, Colour above, double opacity) {
    for (std::size_t k = 0; k < 3; ++k)
        below[k] = static_cast<std::uint8_t>(std::lround((1 - opacity) * below[k] + opacity * above[k]));
    return below;
}

/// The samples of some rows of an image.
class Strip {
public:
    Strip(const Scene& scene, const Renderer& renderer, const Rows& rows)
        : rows_(rows), opacity_(scene.opacity), solid_(rows), water_(rows) {
        renderer.draw(scene.walls, rows, solid_);
        renderer.draw(scene.solid, rows, solid_);
        renderer.draw(scene.water, rows, water_);
        panes_.resize(static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.end - rows.first), 0);
        renderer.forPieces(scene.panes, [&](const auto& points, const Piece&) {
            forTriangle(points, rows, [&](int x, int y, const Fragment& seen) {
                unsigned char& count = panes_[at(x, y)];
                if (seen.depth < std::min(solid_.depth(x, y), water_.depth(x, y)) && count < 255) ++count;
            });
        });
    }

    /// The mean of a pixel's samples.
    Colour pixel(int px, int py) const {
        constexpr int n = fineness * fineness;
        std::array<int, 3> sum{};
        for (int k = 0; k < n; ++k) {
            const Colour seen = sample(fineness * px + k % fineness, fineness * py + k / fineness);
            for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += seen[channel];
        }
        Colour mean{};
        for (std::size_t channel = 0; channel < 3; ++channel)
            mean[channel] = static_cast<std::uint8_t>((sum[channel] + n / 2) / n);
        return mean;
    }

private:
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y - rows_.first) * rows_.width + x; }

    Colour sample(int x, int y) const {
        Colour colour = solid_.colour(x, y);
        if (water_.depth(x, y) < solid_.depth(x, y)) colour = mixed(colour, water_.colour(x, y), opacity_);
        const int panes = panes_[at(x, y)];
        return panes > 0 ? mixed(colour, paneColour, 1 - std::pow(1 - paneOpacity, panes)) : colour;
    }

    Rows rows_;
    double opacity_;
    Layer solid_, water_;
    std::vector<unsigned char> panes_;  // how many are before what is seen
};

}  // namespace

Image render(const Scene& scene, const Camera& camera, const Screen& screen,
             const std::function<Colour(double)>& colourOf) {
    constexpr int height = 32;  // of a strip [pixels]: memory
    const Renderer renderer(camera, screen, colourOf);
    Image image(screen.width, screen.height);
    for (int top = 0; top < screen.height; top += height) {
        const int bottom = std::min(top + height, screen.height);
        const Strip strip(scene, renderer, {fineness * screen.width, fineness * top, fineness * bottom});
        for (int y = top; y < bottom; ++y)
            for (int x = 0; x < screen.width; ++x) image.at(x, y) = strip.pixel(x, y);
    }
    return image;
}

}  // namespace pfem
