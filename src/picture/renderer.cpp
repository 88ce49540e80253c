#include "picture/renderer.hpp"

#include <algorithm>
#include <cmath>

namespace pfem {

namespace {

/// Lambert's light from the upper left over light from everywhere; `depth` is the part that the first can take away.
Colour lit(Colour colour, const Vec<3>& normal, double depth) {
    const double length = normal.norm();
    const double lambert = length > 0 ? std::max(0.0, normal.dot(Vec<3>(-0.36, 0.56, 0.746)) / length) : 1;
    for (auto& channel : colour)
        channel = static_cast<std::uint8_t>(std::lround(channel * (1 - depth * (1 - lambert))));
    return colour;
}

}  // namespace

Renderer::Renderer(const Camera& camera, const Screen& screen, const std::function<Colour(double)>& colourOf)
    : camera_(camera), screen_(screen), grey_(colourOf(std::numeric_limits<double>::quiet_NaN())) {
    for (int band = 0; band < nBands; ++band) colours_.push_back(colourOf(bandFraction(band)));
}

RasterPoint Renderer::place(const Corner3& corner) const {
    const Seen seen = camera_.see(corner.x);
    const Vec<2> pixels = screen_.origin + screen_.scale * Vec<2>(seen.place[0], -seen.place[1]);
    return {fineness * pixels, seen.depth, seen.scale, corner.value, camera_.turn(corner.normal)};
}

Colour Renderer::colour(const Body& body, double value) const {
    if (!body.coloured) return body.plain;
    if (!std::isfinite(value)) return grey_;
    return colours_[static_cast<std::size_t>(std::clamp(std::floor(value * nBands), 0.0, nBands - 1.0))];
}

void Renderer::draw(const Body& body, const Rows& rows, Layer& layer) const {
    forPieces(body.pieces, [&](const auto& points, const Piece& piece) {
        forTriangle(points, rows, [&](int x, int y, const Fragment& seen) {
            const Colour base = colour(body, seen.value);
            layer.put(x, y, seen.depth, piece.lit ? lit(base, seen.normal, body.shade) : base);
        });
    });
    drawBalls(body, rows, layer);
    drawStrokes(body, rows, layer);
}

void Renderer::drawBalls(const Body& body, const Rows& rows, Layer& layer) const {
    for (const Ball& ball : body.balls) {
        const RasterPoint centre = place({ball.centre, Vec<3>::Zero(), ball.value});
        if (!(centre.scale > 0)) continue;
        const double perMetre = fineness * screen_.scale * centre.scale;
        const double radius = std::max(ball.radius * perMetre, 0.9 * fineness * screen_.pen);
        forBall(centre, radius, radius / perMetre, rows, [&](int x, int y, const Fragment& seen) {
            layer.put(x, y, seen.depth, lit(colour(body, seen.value), seen.normal, body.shade));
        });
    }
}

/// Lines lie on surfaces: they are drawn as if a little nearer.
void Renderer::drawStrokes(const Body& body, const Rows& rows, Layer& layer) const {
    for (const Stroke& stroke : body.strokes) {
        const RasterPoint a = place({stroke.ends[0]}), b = place({stroke.ends[1]});
        if (!(a.scale > 0 && b.scale > 0)) continue;
        const double pen = stroke.thickness * screen_.pen, nearer = 1.5 * std::max(pen, 1.0) / screen_.scale;
        forLine(a, b, fineness * pen, rows,
                [&](int x, int y, double depth) { layer.put(x, y, depth - nearer, stroke.colour); });
    }
}

}  // namespace pfem
