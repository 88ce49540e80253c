#pragma once
// One state in space, drawn into one rectangle of a canvas.

#include "picture/scene.hpp"

namespace pfem {

/// What all panels of a sheet share: the camera, and the part of its picture that is shown.
struct Framing {
    Camera camera;
    Window window;
};

/// All of all states, walls too, or the chosen box; with a margin. Throws UserError when there is nothing.
Framing framingOf(const std::vector<State<3>>& states, const SpaceOptions& options);

/// Pixels, also in SVG and PDF: twice as fine there.
void drawPanel(Canvas& canvas, const Box& box, const Framing& framing, const Scene& scene, const PanelStyle<3>& style);

/// The directions of x, y and z as lines from `at`.
void drawAxes(Canvas& canvas, const Camera& camera, const Vec<2>& at, double length);

}  // namespace pfem
