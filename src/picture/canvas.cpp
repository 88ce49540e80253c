#include "picture/canvas.hpp"

#include <algorithm>
#include <cmath>

namespace pfem {

Canvas::Canvas(int width, int height, Colour background) : fine_(factor_ * width, factor_ * height, background) {
    noClip();
}

void Canvas::clip(const Box& box) { clip_ = box; }
void Canvas::noClip() { clip_ = {0, 0, double(fine_.width) / factor_, double(fine_.height) / factor_}; }

/// The samples whose centres lie in the box and in the clip.
Canvas::Samples Canvas::samplesIn(const Box& box) const {
    auto index = [](double pixel, int limit) {
        return static_cast<int>(std::clamp(std::ceil(pixel * factor_ - 0.5), 0.0, static_cast<double>(limit)));
    };
    return {index(std::max(box.left, clip_.left), fine_.width), index(std::min(box.right, clip_.right), fine_.width),
            index(std::max(box.top, clip_.top), fine_.height), index(std::min(box.bottom, clip_.bottom), fine_.height)};
}

void Canvas::rectangle(const Box& box, Colour colour) {
    const Samples s = samplesIn(box);
    for (int y = s.y0; y < s.y1; ++y)
        for (int x = s.x0; x < s.x1; ++x) fine_.at(x, y) = colour;
}

void Canvas::triangle(const std::array<Vec<2>, 3>& p, const std::array<double, 3>& values,
                      const std::function<Colour(double)>& colourOf) {
    const auto cross = [](const Vec<2>& u, const Vec<2>& v) { return u[0] * v[1] - u[1] * v[0]; };
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    if (area == 0 || !std::isfinite(area)) return;
    const auto [left, right] = std::minmax({p[0][0], p[1][0], p[2][0]});
    const auto [top, bottom] = std::minmax({p[0][1], p[1][1], p[2][1]});
    const Samples s = samplesIn({left, top, right, bottom});
    for (int y = s.y0; y < s.y1; ++y)
        for (int x = s.x0; x < s.x1; ++x) {
            const Vec<2> at((x + 0.5) / factor_, (y + 0.5) / factor_);
            const double b = cross(at - p[0], p[2] - p[0]) / area, c = cross(p[1] - p[0], at - p[0]) / area;
            constexpr double seam = 1e-9;  // neighbours leave no gap
            if (b < -seam || c < -seam || b + c > 1 + seam) continue;
            fine_.at(x, y) = colourOf((1 - b - c) * values[0] + b * values[1] + c * values[2]);
        }
}

void Canvas::triangle(const std::array<Vec<2>, 3>& corners, Colour colour) {
    triangle(corners, {0, 0, 0}, [&](double) { return colour; });
}

void Canvas::line(const Vec<2>& a, const Vec<2>& b, double thickness, Colour colour) {
    const double r = thickness / 2;
    const Samples s = samplesIn(
        {std::min(a[0], b[0]) - r, std::min(a[1], b[1]) - r, std::max(a[0], b[0]) + r, std::max(a[1], b[1]) + r});
    const Vec<2> along = b - a;
    const double length2 = along.squaredNorm();
    for (int y = s.y0; y < s.y1; ++y)
        for (int x = s.x0; x < s.x1; ++x) {
            const Vec<2> at((x + 0.5) / factor_, (y + 0.5) / factor_);
            const double t = length2 > 0 ? std::clamp((at - a).dot(along) / length2, 0.0, 1.0) : 0;
            if ((at - a - t * along).squaredNorm() <= r * r) fine_.at(x, y) = colour;
        }
}

Image Canvas::image() const {
    Image image(fine_.width / factor_, fine_.height / factor_);
    constexpr int n = factor_ * factor_;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            std::array<int, 3> sum{};
            for (int k = 0; k < n; ++k) {
                const Colour& sample = fine_.at(factor_ * x + k % factor_, factor_ * y + k / factor_);
                for (std::size_t c = 0; c < 3; ++c) sum[c] += sample[c];
            }
            for (std::size_t c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<std::uint8_t>((sum[c] + n / 2) / n);
        }
    return image;
}

}  // namespace pfem
