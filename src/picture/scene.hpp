#pragma once
// What there is to draw of a state in space: triangles, lines and balls, cut by a plane.

#include <optional>
#include <string>
#include <vector>

#include "picture/camera.hpp"
#include "picture/cut.hpp"
#include "picture/image.hpp"
#include "picture/panel.hpp"

namespace pfem {

/// How walls are shown. inside: those sides that fluid may touch, where they face the eye; always with their edges.
enum class WallLook { inside, translucent, outline, none };

/// Their words, in the order of the values.
const std::vector<std::string>& wallLooks();

/// What is chosen for pictures in space beside what the plane has, too.
struct SpaceOptions {
    View view;
    std::optional<CuttingPlane> plane;
    WallLook walls = WallLook::inside;
    std::optional<double> opacity;             // of the water; default: 1, less where it hides what is coloured
    std::optional<std::array<Vec<3>, 2>> box;  // fills the panel; default: all of all states
};

/// A part of a surface. Cuts are not lit: they have the colours of the scale.
struct Piece {
    std::array<Corner3, 3> corners;
    bool lit = true;
};

struct Stroke {
    std::array<Vec<3>, 2> ends;
    Colour colour;
    double thickness;  // in pens
};

struct Ball {
    Vec<3> centre;
    double radius, value;
};

/// Values are fractions of the range.
struct Body {
    Colour plain;
    bool coloured = false;
    double shade = 0;  // of a face that gets no light, 0 - 1
    std::vector<Piece> pieces;
    std::vector<Stroke> strokes;
    std::vector<Ball> balls;
};

struct Scene {
    Body water, solid;
    Body walls;                // opaque, with the edges
    std::vector<Piece> panes;  // translucent walls
    double opacity = 1;        // of the water
};

/// Sides that do not face the camera are left out.
Scene makeScene(const State<3>& state, const PanelStyle<3>& style, const SpaceOptions& options, const Camera& camera);

}  // namespace pfem
