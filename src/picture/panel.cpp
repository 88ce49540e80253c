#include "picture/panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/adjacency.hpp"

namespace pfem {

namespace {

constexpr Colour plainFluid{176, 209, 236};
constexpr Colour plainSolid{236, 196, 148};
constexpr Colour solidOutline{205, 85, 10};  // stands out from all colour maps and from white
constexpr Colour wallColour{70, 70, 70};

/// Lines of the mesh: light over dark colours.
Colour meshColourOn(Colour fill) {
    const bool dark = 0.3 * fill[0] + 0.6 * fill[1] + 0.1 * fill[2] < 90;
    return dark ? Colour{165, 165, 165} : Colour{40, 40, 40};
}

/// Draws the parts of one state; places are turned to pixels here.
class Painter {
public:
    Painter(Canvas& canvas, const Box& box, const Window& window, const State<2>& state, const PanelStyle<2>& style)
        : canvas_(canvas),
          box_(box),
          low_(window.low),
          scale_(box.width() / window.size()[0]),
          state_(state),
          style_(style) {}

    void cells(const Cells<2>& cells, Region region, Colour plain) {
        const bool coloured = hasValues(*style_.field, region);
        std::vector<ShadedTriangle> shaded;
        std::vector<std::array<Vec<2>, 3>> flat;
        for (const auto& cell : cells.nodes) {
            const std::array<Vec<2>, 3> corners{place(cell[0]), place(cell[1]), place(cell[2])};
            if (coloured)
                shaded.push_back({corners, {fraction(cell[0]), fraction(cell[1]), fraction(cell[2])}});
            else
                flat.push_back(corners);
        }
        canvas_.triangles(shaded, style_.colourOf);
        canvas_.triangles(flat, plain);
        if (!style_.mesh) return;
        for (const auto& cell : cells.nodes)
            for (std::size_t i = 0; i < 3; ++i) {
                const int a = cell[i], b = cell[(i + 1) % 3];
                const Colour fill = coloured ? style_.colourOf(0.5 * (fraction(a) + fraction(b))) : plain;
                canvas_.line(place(a), place(b), 0.4 * style_.pen, meshColourOn(fill));
            }
    }

    void outline(const Cells<2>& cells) {
        for (const auto& face : boundaryFaces<2>(cells.nodes, nodeToCells<2>(cells.nodes, state_.nodes.size())))
            canvas_.line(place(face.nodes[0]), place(face.nodes[1]), 1.5 * style_.pen, solidOutline);
    }

    void walls() {
        for (const auto& patch : state_.mesh.patches)
            for (const auto& face : patch.faces)
                canvas_.line(place(face[0]), place(face[1]), 2 * style_.pen, wallColour);
    }

    void drops() {
        for (int i = 0; i < state_.nodes.size(); ++i) {
            const double volume = state_.nodes.dropVolume[i];
            if (volume <= 0) continue;
            const double radius = std::max(0.9 * style_.pen, scale_ * std::sqrt(volume / 3.141592653589793));
            canvas_.disc(place(i), radius,
                         hasValues(*style_.field, Region::fluid) ? style_.colourOf(fraction(i)) : plainFluid);
        }
    }

private:
    Vec<2> place(int node) const {
        const Vec<2> metres = state_.nodes.x[node] - low_;
        return {box_.left + scale_ * metres[0], box_.bottom - scale_ * metres[1]};
    }
    double fraction(int node) const {
        return (style_.field->value(state_.nodes, node) - style_.range.low) / (style_.range.high - style_.range.low);
    }

    Canvas& canvas_;
    Box box_;
    Vec<2> low_;
    double scale_;  // pixels per metre
    const State<2>& state_;
    const PanelStyle<2>& style_;
};

template <int Dim, class Function>
void forNodes(const Cells<Dim>& cells, const Function& function) {
    for (const auto& cell : cells.nodes) std::for_each(cell.begin(), cell.end(), function);
}

}  // namespace

void drawPanel(Canvas& canvas, const Box& box, const Window& window, const State<2>& state,
               const PanelStyle<2>& style) {
    const double rim = style.pen;  // lines on the edge of the window keep their thickness
    canvas.clip({box.left - rim, box.top, box.right + rim, box.bottom + rim});
    Painter painter(canvas, box, window, state, style);
    painter.cells(state.mesh.fluid, Region::fluid, plainFluid);
    painter.drops();
    painter.walls();
    painter.cells(state.mesh.solid, Region::solid, plainSolid);
    painter.outline(state.mesh.solid);
    canvas.noClip();
}

Window windowOf(const State<2>& state) {
    constexpr double huge = std::numeric_limits<double>::max();
    Window window{Vec<2>::Constant(huge), Vec<2>::Constant(-huge)};
    const auto include = [&](int i) {
        window.low = window.low.cwiseMin(state.nodes.x[i]);
        window.high = window.high.cwiseMax(state.nodes.x[i]);
    };
    forNodes<2>(state.mesh.fluid, include);
    forNodes<2>(state.mesh.solid, include);
    return window;
}

template <int Dim>
ValueRange rangeOf(const State<Dim>& state, const PictureField<Dim>& field) {
    ValueRange range{std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
    const auto include = [&](int i) {
        const double value = field.value(state.nodes, i);
        range = {std::min(range.low, value), std::max(range.high, value)};
    };
    if (hasValues(field, Region::fluid)) forNodes<Dim>(state.mesh.fluid, include);
    if (hasValues(field, Region::solid)) forNodes<Dim>(state.mesh.solid, include);
    return range;
}

template ValueRange rangeOf(const State<2>&, const PictureField<2>&);
template ValueRange rangeOf(const State<3>&, const PictureField<3>&);

}  // namespace pfem
