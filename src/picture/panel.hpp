#pragma once
// One state, drawn into one rectangle of a canvas.

#include <functional>

#include "picture/canvas.hpp"
#include "picture/pictureField.hpp"
#include "state/state.hpp"

namespace pfem {

/// The part of the plane that a picture shows [m].
struct Window {
    Vec<2> low = Vec<2>::Zero(), high = Vec<2>::Zero();

    Vec<2> size() const { return high - low; }
};

struct ValueRange {
    double low, high;
};

template <int Dim>
struct PanelStyle {
    const PictureField<Dim>* field = nullptr;
    ValueRange range{0, 1};                  // of the field, from one end of the colours to the other
    std::function<Colour(double)> colourOf;  // of a fraction of the range
    bool mesh = false;                       // draw the triangles' edges
    double pen = 1;                          // thickness of a thin line [pixels]
};

/// Fluid, solids with an outline, walls as lines, isolated particles as dots of their volume.
/// Where the field has no meaning the body has a plain colour.
void drawPanel(Canvas& canvas, const Box& box, const Window& window, const State<2>& state, const PanelStyle<2>& style);

/// The smallest window with all triangles of the state.
Window windowOf(const State<2>& state);

/// Least and largest value of the field at the nodes of the cells where it has a meaning.
/// Empty (low > high) when there are none.
template <int Dim>
ValueRange rangeOf(const State<Dim>& state, const PictureField<Dim>& field);

}  // namespace pfem
