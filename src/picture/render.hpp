#pragma once
// A scene to pixels: the nearest surface at each sample, with light.

#include "picture/scene.hpp"

namespace pfem {

/// Where the camera's picture lies on an image.
struct Screen {
    int width, height;  // [pixels]
    Vec<2> origin;      // of the camera's centre [pixels, y downwards]
    double scale;       // pixels per metre
    double pen = 1;     // thickness of a thin line [pixels]
};

/// 3 x 3 samples a pixel; the same bytes every time.
Image render(const Scene& scene, const Camera& camera, const Screen& screen,
             const std::function<Colour(double)>& colourOf);

}  // namespace pfem
