#include "picture/strokeFont.hpp"

#include <algorithm>
#include <sstream>

#include "picture/glyphs.hpp"

namespace pfem {

namespace {

using Line = std::vector<Vec<2>>;

/// Chaikin's corner cutting, three times: a quadratic spline.
Line smooth(Line points, bool closed) {
    for (int round = 0; round < 3; ++round) {
        Line finer;
        const std::size_t n = points.size();
        if (!closed) finer.push_back(points.front());
        for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
            const Vec<2>& a = points[i];
            const Vec<2>& b = points[(i + 1) % n];
            // the ends of an open line stay where they are
            if (closed || i > 0) finer.push_back(0.75 * a + 0.25 * b);
            if (closed || i + 2 < n) finer.push_back(0.25 * a + 0.75 * b);
        }
        if (!closed) finer.push_back(points.back());
        points = std::move(finer);
    }
    if (closed) points.push_back(points.front());
    return points;
}

std::vector<Line> strokesOf(char c) {
    const auto glyph = glyphs().find(c);
    std::istringstream text(glyph == glyphs().end() ? "-0d4d4m0m0d" : glyph->second);
    std::vector<Line> strokes;
    for (std::string stroke; text >> stroke;) {
        Line points;
        for (std::size_t i = 1; i + 1 < stroke.size(); i += 2)
            points.emplace_back(stroke[i] - '0', stroke[i + 1] - 'd');
        strokes.push_back(stroke[0] == '-' ? points : smooth(points, stroke[0] == 'o'));
    }
    return strokes;
}

constexpr double unit(double size) { return size / 9; }

double advance(const std::vector<Line>& strokes) {
    double right = strokes.empty() ? 2 : 0;
    for (const auto& stroke : strokes)
        for (const auto& point : stroke) right = std::max(right, point[0]);
    return right + 2.2;
}

}  // namespace

double textWidth(const std::string& text, double size) {
    double width = 0;
    for (const char c : text) width += advance(strokesOf(c));
    return text.empty() ? 0 : (width - 2.2) * unit(size);
}

void drawText(Canvas& canvas, const std::string& text, const Vec<2>& at, double size, Align align, Colour colour,
              double weight) {
    const double shift = align == Align::left ? 0 : align == Align::centre ? 0.5 : 1;
    Vec<2> pen(at[0] - shift * textWidth(text, size), at[1]);
    for (const char c : text) {
        const auto strokes = strokesOf(c);
        const auto place = [&](const Vec<2>& p) {
            return Vec<2>(pen[0] + p[0] * unit(size), pen[1] - p[1] * unit(size));
        };
        for (const auto& stroke : strokes)
            for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
                canvas.line(place(stroke[i]), place(stroke[i + 1]), weight * 1.25 * unit(size), colour);
        pen[0] += advance(strokes) * unit(size);
    }
}

}  // namespace pfem
