#pragma once
// What pictures are drawn on, by Cairo: pixels, or the paths of an SVG or PDF file.

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/types.hpp"
#include "picture/bands.hpp"
#include "picture/image.hpp"

namespace pfem {

/// A rectangle in pixels, y downwards.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

enum class PictureFormat { png, svg, pdf };

/// Their words, in the order of the values.
const std::vector<std::string>& pictureFormats();

/// Throws UserError with the valid list.
PictureFormat pictureFormat(const std::string& word);

enum class Align { left, centre, right };

/// Coordinates are pixels of the finished picture, y downwards; parts of pixels are meaningful.
class Canvas {
public:
    static constexpr int largest = 32767;  // width and height: Cairo's limit

    /// White. Throws UserError when there is no memory for it.
    Canvas(int width, int height, PictureFormat format = PictureFormat::png);
    ~Canvas();
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;

    int width() const { return width_; }
    int height() const { return height_; }
    PictureFormat format() const { return format_; }

    /// Nothing is drawn outside of `box` until the next call.
    void clip(const Box& box);
    void noClip();

    void rectangle(const Box& box, Colour colour);
    void triangles(const std::vector<std::array<Vec<2>, 3>>& corners, Colour colour);

    /// Each point gets the colour of its linearly interpolated value, to a 256th of the scale.
    void triangles(const std::vector<ShadedTriangle>& triangles, const std::function<Colour(double)>& colourOf);

    /// Pixels with their top left corner at (left, top), `fine` of them to one of the canvas in each direction.
    void picture(const Image& image, int left, int top, int fine = 1);

    /// With round ends; a line of no length is a dot.
    void line(const Vec<2>& a, const Vec<2>& b, double thickness, Colour colour);
    void disc(const Vec<2>& centre, double radius, Colour colour) { line(centre, centre, 2 * radius, colour); }

    /// `at`: the baseline's left end, middle or right end; `size`: height of a capital letter [pixels].
    void text(const std::string& words, const Vec<2>& at, double size, Align align = Align::left);

    /// [pixels]
    double textWidth(const std::string& words, double size) const;

    /// The pixels of a PNG.
    Image image() const;

    /// The bytes of the finished file; nothing can be drawn afterwards.
    std::string file();

private:
    struct Cairo;
    void fill(const std::vector<Polygon>& polygons, Colour colour);

    int width_, height_;
    PictureFormat format_;
    std::unique_ptr<Cairo> cairo_;
};

/// The bytes of a PNG file.
std::string pngOf(const Image& image);

}  // namespace pfem
