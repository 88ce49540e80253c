#pragma once
// Which samples of a raster lie in triangles, on lines and in balls, and how far away each is there.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/types.hpp"

namespace pfem {

/// A point on the raster [samples, y downwards]. What is linear in space is, times `scale`, linear on the raster.
struct RasterPoint {
    Vec<2> at;
    double depth = 0, scale = 1;
    double value = 0;
    Vec<3> normal = Vec<3>::Zero();  // right, up, to the eye
};

/// What a sample sees.
struct Fragment {
    double depth, value;
    Vec<3> normal;
};

/// Samples have their places in the middle: row y at y + 0.5.
struct Rows {
    int width, first, end;
};

/// Twice the area of a, b, p; exactly the opposite for b, a, p.
inline double turnOf(const Vec<2>& a, const Vec<2>& b, const Vec<2>& p) {
    if (b[0] < a[0] || (b[0] == a[0] && b[1] < a[1])) return -turnOf(b, a, p);
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// f(x, y) for the samples in a rectangle.
template <class F>
void forSamples(const Vec<2>& low, const Vec<2>& high, const Rows& rows, const F& f) {
    if (!low.allFinite() || !high.allFinite()) return;
    const auto range = [](double from, double to, int first, int end) {
        return std::pair(static_cast<int>(std::clamp<double>(std::ceil(from - 0.5), first, end)),
                         static_cast<int>(std::clamp<double>(std::floor(to - 0.5) + 1, first, end)));
    };
    const auto [left, right] = range(low[0], high[0], 0, rows.width);
    const auto [top, bottom] = range(low[1], high[1], rows.first, rows.end);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) f(x, y);
}

/// f(x, y, fragment). A sample on the common edge of two triangles belongs to one of them.
template <class F>
void forTriangle(const std::array<RasterPoint, 3>& t, const Rows& rows, const F& f) {
    const double area = turnOf(t[0].at, t[1].at, t[2].at);
    if (area == 0) return;
    const auto inside = [&](const Vec<2>& a, const Vec<2>& b, double turn) {
        const Vec<2> d = area > 0 ? b - a : a - b;
        return turn / area > 0 || (turn == 0 && (d[1] < 0 || (d[1] == 0 && d[0] > 0)));
    };
    const RasterPoint &a = t[0], &b = t[1], &c = t[2];
    const auto draw = [&](int x, int y) {
        const Vec<2> p(x + 0.5, y + 0.5);
        const double u = turnOf(b.at, c.at, p), v = turnOf(c.at, a.at, p), w = turnOf(a.at, b.at, p);
        if (!inside(b.at, c.at, u) || !inside(c.at, a.at, v) || !inside(a.at, b.at, w)) return;
        const double A = u * a.scale, B = v * b.scale, C = w * c.scale, sum = A + B + C;
        f(x, y,
          Fragment{(A * a.depth + B * b.depth + C * c.depth) / sum, (A * a.value + B * b.value + C * c.value) / sum,
                   (A * a.normal + B * b.normal + C * c.normal) / sum});
    };
    forSamples(a.at.cwiseMin(b.at).cwiseMin(c.at), a.at.cwiseMax(b.at).cwiseMax(c.at), rows, draw);
}

/// f(x, y, depth) for a line with round ends.
template <class F>
void forLine(const RasterPoint& a, const RasterPoint& b, double thickness, const Rows& rows, const F& f) {
    const Vec<2> d = b.at - a.at, rim = Vec<2>::Constant(0.5 * thickness);
    forSamples(a.at.cwiseMin(b.at) - rim, a.at.cwiseMax(b.at) + rim, rows, [&](int x, int y) {
        const Vec<2> p = Vec<2>(x + 0.5, y + 0.5) - a.at;
        const double t = d.squaredNorm() > 0 ? std::clamp(p.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
        if ((p - t * d).norm() > 0.5 * thickness) return;
        f(x, y, ((1 - t) * a.scale * a.depth + t * b.scale * b.depth) / ((1 - t) * a.scale + t * b.scale));
    });
}

/// f(x, y, fragment) for the near half of a ball: its radius in samples and in metres.
template <class F>
void forBall(const RasterPoint& centre, double radius, double metres, const Rows& rows, const F& f) {
    const Vec<2> rim = Vec<2>::Constant(radius);
    forSamples(centre.at - rim, centre.at + rim, rows, [&](int x, int y) {
        const Vec<2> r = (Vec<2>(x + 0.5, y + 0.5) - centre.at) / radius;
        if (r.squaredNorm() > 1) return;
        const Vec<3> normal(r[0], -r[1], std::sqrt(1 - r.squaredNorm()));
        f(x, y, Fragment{centre.depth - metres * normal[2], centre.value, normal});
    });
}

}  // namespace pfem
