#include "picture/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int n) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), n);
    return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw UserError(std::string("cannot draw the picture: ") + cairo_status_to_string(status));
}

struct Destroy {
    void operator()(cairo_t* c) const { cairo_destroy(c); }
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};

std::unique_ptr<cairo_surface_t, Destroy> surfaceOf(const Image& image) {
    std::unique_ptr<cairo_surface_t, Destroy> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
    check(cairo_surface_status(surface.get()));
    unsigned char* const data = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Colour& c = image.at(x, y);
            reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride)[x] =
                static_cast<std::uint32_t>(c[0]) << 16 | static_cast<std::uint32_t>(c[1]) << 8 | c[2];
        }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

}  // namespace

const std::vector<std::string>& pictureFormats() {
    static const std::vector<std::string> words{"png", "svg", "pdf"};
    return words;
}

PictureFormat pictureFormat(const std::string& word) {
    const auto& words = pictureFormats();
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) throw UserError(notValid(word, "format of pictures", words));
    return static_cast<PictureFormat>(found - words.begin());
}

/// Pixels are drawn several times as fine and averaged: areas that meet leave no gap, as they would with smoothed edges
/// each. The paths of SVG and PDF are smoothed by whoever shows them; there, areas get an outline of their own colour.
struct Canvas::Cairo {
    std::string bytes;  // of SVG and PDF; the surface writes them and goes first
    PictureFormat format;
    int factor = 1;  // samples per pixel and direction
    std::unique_ptr<cairo_surface_t, Destroy> surface;
    std::unique_ptr<cairo_t, Destroy> context;

    Cairo(int width, int height, PictureFormat form) : format(form) {
        constexpr double points = 0.75;  // per pixel, in PDF
        if (format == PictureFormat::png) {
            factor = std::clamp(largest / std::max({width, height, 1}), 1, 3);
            surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, factor * width, factor * height));
        } else if (format == PictureFormat::svg) {
            surface.reset(cairo_svg_surface_create_for_stream(append, &bytes, width, height));
            cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
        } else {
            surface.reset(cairo_pdf_surface_create_for_stream(append, &bytes, points * width, points * height));
        }
        check(cairo_surface_status(surface.get()));
        context.reset(cairo_create(surface.get()));
        cairo_t* const c = context.get();
        const double scale = format == PictureFormat::pdf ? points : factor;
        cairo_scale(c, scale, scale);
        cairo_set_source_rgb(c, 1, 1, 1);
        cairo_paint(c);
        cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
        cairo_select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_font_options_t* const options = cairo_font_options_create();  // letters do not keep to pixels
        cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
        cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
        cairo_set_font_options(c, options);
        cairo_font_options_destroy(options);
    }

    void colour(Colour rgb) const {
        cairo_set_source_rgb(context.get(), rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
    }

    /// Choose the font's size such that capitals have this height.
    void capitals(double size) const {
        cairo_text_extents_t extents;
        cairo_set_font_size(context.get(), 100);
        cairo_text_extents(context.get(), "H", &extents);
        cairo_set_font_size(context.get(), extents.height > 0 ? 100 * size / extents.height : size / 0.73);
    }

    double advance(const std::string& words) const {
        cairo_text_extents_t extents;
        cairo_text_extents(context.get(), words.c_str(), &extents);
        return extents.x_advance;
    }
};

Canvas::Canvas(int width, int height, PictureFormat format)
    : width_(width), height_(height), format_(format), cairo_(std::make_unique<Cairo>(width, height, format)) {}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

void Canvas::clip(const Box& box) {
    noClip();
    cairo_t* const c = cairo_->context.get();
    cairo_rectangle(c, box.left, box.top, box.width(), box.height());
    cairo_clip(c);
}

void Canvas::noClip() { cairo_reset_clip(cairo_->context.get()); }

void Canvas::fill(const std::vector<Polygon>& polygons, Colour colour) {
    cairo_t* const c = cairo_->context.get();
    cairo_->colour(colour);
    cairo_new_path(c);
    for (const Polygon& polygon : polygons) {
        cairo_new_sub_path(c);
        for (const Vec<2>& x : polygon) cairo_line_to(c, x[0], x[1]);
        cairo_close_path(c);
    }
    if (cairo_->format == PictureFormat::png) {
        cairo_set_antialias(c, CAIRO_ANTIALIAS_NONE);
        cairo_fill(c);
        cairo_set_antialias(c, CAIRO_ANTIALIAS_DEFAULT);
    } else {
        cairo_fill_preserve(c);
        cairo_set_line_width(c, 0.3);
        cairo_stroke(c);
    }
}

void Canvas::rectangle(const Box& box, Colour colour) {
    fill({{{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}}, colour);
}

void Canvas::triangles(const std::vector<std::array<Vec<2>, 3>>& corners, Colour colour) {
    std::vector<Polygon> polygons;
    for (const auto& [a, b, c] : corners)
        if ((a + b + c).allFinite()) polygons.push_back({a, b, c});
    if (!polygons.empty()) fill(polygons, colour);
}

void Canvas::triangles(const std::vector<ShadedTriangle>& triangles, const std::function<Colour(double)>& colourOf) {
    std::vector<std::array<Vec<2>, 3>> without;  // a value
    for (const auto& [corners, f] : triangles)
        if (!std::isfinite(f[0] + f[1] + f[2])) without.push_back(corners);
    this->triangles(without, colourOf(std::nan("")));
    const auto bands = bandsOf(triangles);
    for (int band = 0; band < nBands; ++band)
        if (!bands[band].empty()) fill(bands[band], colourOf(bandFraction(band)));
}

void Canvas::picture(const Image& image, int left, int top, int fine) {
    cairo_t* const c = cairo_->context.get();
    const auto source = surfaceOf(image);
    cairo_save(c);
    cairo_translate(c, left, top);
    cairo_scale(c, 1.0 / fine, 1.0 / fine);
    cairo_set_source_surface(c, source.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_NEAREST);
    cairo_paint(c);
    cairo_restore(c);
}

void Canvas::line(const Vec<2>& a, const Vec<2>& b, double thickness, Colour colour) {
    cairo_t* const c = cairo_->context.get();
    cairo_->colour(colour);
    cairo_set_line_width(c, thickness);
    cairo_move_to(c, a[0], a[1]);
    cairo_line_to(c, b[0], b[1]);
    cairo_stroke(c);
}

double Canvas::textWidth(const std::string& words, double size) const {
    cairo_->capitals(size);
    return cairo_->advance(words);
}

void Canvas::text(const std::string& words, const Vec<2>& at, double size, Align align) {
    const double shift = align == Align::left ? 0 : align == Align::centre ? 0.5 : 1;
    cairo_t* const c = cairo_->context.get();
    cairo_->colour(black);
    cairo_move_to(c, at[0] - shift * textWidth(words, size), at[1]);
    cairo_show_text(c, words.c_str());
    cairo_new_path(c);
}

Image Canvas::image() const {
    if (cairo_->format != PictureFormat::png) throw InternalError("only a PNG has pixels");
    cairo_surface_t* const surface = cairo_->surface.get();
    cairo_surface_flush(surface);
    const unsigned char* const data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface), factor = cairo_->factor, n = factor * factor;
    Image image(width_, height_);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            std::array<unsigned, 3> sum{};
            for (int k = 0; k < n; ++k) {
                const unsigned char* const row = data + static_cast<std::ptrdiff_t>(factor * y + k / factor) * stride;
                const std::uint32_t sample = reinterpret_cast<const std::uint32_t*>(row)[factor * x + k % factor];
                for (int channel = 0; channel < 3; ++channel) sum[channel] += (sample >> (16 - 8 * channel)) & 0xff;
            }
            for (std::size_t channel = 0; channel < 3; ++channel)
                image.at(x, y)[channel] = static_cast<std::uint8_t>((sum[channel] + n / 2) / n);
        }
    return image;
}

std::string Canvas::file() {
    if (cairo_->format == PictureFormat::png) return pngOf(image());
    check(cairo_status(cairo_->context.get()));
    cairo_surface_finish(cairo_->surface.get());
    check(cairo_surface_status(cairo_->surface.get()));
    return std::move(cairo_->bytes);
}

std::string pngOf(const Image& image) {
    const auto surface = surfaceOf(image);
    std::string bytes;
    check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
    return bytes;
}

}  // namespace pfem
