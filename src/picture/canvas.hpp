#pragma once
// A small rasteriser: triangles, thick lines and discs, smoothed by drawing each pixel several times.

#include <array>
#include <functional>
#include <vector>

#include "base/types.hpp"
#include "picture/image.hpp"

namespace pfem {

/// A rectangle in pixels, y downwards.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

/// Coordinates are pixels of the finished picture, y downwards; parts of pixels are meaningful.
class Canvas {
public:
    Canvas(int width, int height, Colour background = white);

    /// Nothing is drawn outside of `box` until the next call.
    void clip(const Box& box);
    void noClip();

    void rectangle(const Box& box, Colour colour);

    /// The corners have values; each point gets the colour of its linearly interpolated value.
    void triangle(const std::array<Vec<2>, 3>& corners, const std::array<double, 3>& values,
                  const std::function<Colour(double)>& colourOf);
    void triangle(const std::array<Vec<2>, 3>& corners, Colour colour);

    /// With round ends; a line of no length is a dot.
    void line(const Vec<2>& a, const Vec<2>& b, double thickness, Colour colour);
    void disc(const Vec<2>& centre, double radius, Colour colour) { line(centre, centre, 2 * radius, colour); }

    /// The mean over each pixel's samples.
    Image image() const;

private:
    struct Samples {
        int x0, x1, y0, y1;  // half-open
    };
    Samples samplesIn(const Box& box) const;

    static constexpr int factor_ = 3;  // samples per pixel and direction
    Image fine_;
    Box clip_;
};

}  // namespace pfem
