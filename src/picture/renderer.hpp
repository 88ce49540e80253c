#pragma once
// Bodies to samples: each sample takes what is nearest, with its light.

#include "picture/layer.hpp"
#include "picture/render.hpp"

namespace pfem {

inline constexpr int fineness = 3;  // samples a pixel and direction

class Renderer {
public:
    Renderer(const Camera& camera, const Screen& screen, const std::function<Colour(double)>& colourOf);

    void draw(const Body& body, const Rows& rows, Layer& layer) const;

    /// f(points, piece) for the pieces that are before the eye.
    template <class F>
    void forPieces(const std::vector<Piece>& pieces, const F& f) const {
        for (const Piece& piece : pieces) {
            const auto& [a, b, c] = piece.corners;
            const std::array<RasterPoint, 3> points{place(a), place(b), place(c)};
            if (points[0].scale > 0 && points[1].scale > 0 && points[2].scale > 0) f(points, piece);
        }
    }

private:
    RasterPoint place(const Corner3& corner) const;
    Colour colour(const Body& body, double value) const;
    void drawBalls(const Body& body, const Rows& rows, Layer& layer) const;
    void drawStrokes(const Body& body, const Rows& rows, Layer& layer) const;

    const Camera& camera_;
    const Screen& screen_;
    std::vector<Colour> colours_;  // of the bands of the scale
    Colour grey_;                  // where the field is not finite
};

}  // namespace pfem
