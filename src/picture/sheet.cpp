#include "picture/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "picture/layout.hpp"
#include "picture/panel3.hpp"

namespace pfem {

namespace {

Window commonWindow(const std::vector<State<2>>& states) {
    Window window = windowOf(states.front());
    for (const auto& state : states) {
        const Window other = windowOf(state);
        window = {window.low.cwiseMin(other.low), window.high.cwiseMax(other.high)};
    }
    if (!(window.size().minCoeff() > 0)) throw UserError("the selected times hold nothing that can be drawn");
    const double margin = 0.03 * window.size().maxCoeff();
    return {window.low - Vec<2>::Constant(margin), window.high + Vec<2>::Constant(margin)};
}

template <int Dim>
ValueRange commonRange(const std::vector<State<Dim>>& states, const PictureField<Dim>& field) {
    ValueRange range = rangeOf(states.front(), field);
    for (const auto& state : states) {
        const ValueRange other = rangeOf(state, field);
        range = {std::min(range.low, other.low), std::max(range.high, other.high)};
    }
    if (range.low > range.high) return {0, 1};  // no body has the field
    if (range.low == range.high) return {range.low, range.low + (range.low == 0 ? 1 : std::abs(range.low))};
    return range;
}

/// In space water's surface has little pressure to show.
template <int Dim>
std::string fieldName(const std::vector<State<Dim>>& states, const SheetOptions& options) {
    if (!options.field.empty()) return options.field;
    if (Dim == 2) return "p";
    return std::any_of(states.begin(), states.end(), [](const auto& s) { return s.mesh.solid.size() > 0; }) ? "vonMises"
                                                                                                            : "U";
}

/// A sheet whose panels are drawn by draw(canvas, box, state, style).
template <int Dim, class Draw>
Canvas sheetOf(const std::vector<State<Dim>>& states, const SheetOptions& options, const Layout& layout,
               const Draw& draw) {
    const PictureField<Dim>& field = pictureField<Dim>(fieldName(states, options));
    const ColourMap colours(options.colours);
    const ValueRange range = options.range ? *options.range : commonRange(states, field);
    Canvas canvas(layout.width, layout.height, options.format);
    PanelStyle<Dim> style;
    style.field = &field;
    style.range = range;
    style.colourOf = [&](double fraction) { return colours(fraction); };
    style.mesh = options.mesh;
    style.pen = std::max(0.7, layout.panelWidth / 500);
    for (std::size_t k = 0; k < states.size(); ++k) {
        const Box box = layout.panel(static_cast<int>(k));
        draw(canvas, box, states[k], style);
        canvas.text(fmt::format("t = {:.6g} s", states[k].time.value), {box.left, box.top - 0.6 * layout.text},
                    layout.text);
    }
    if (field.value) drawColourBar(canvas, layout, range, field.title, colours);
    return canvas;
}

Layout layoutOf(std::size_t panels, const Window& window, const SheetOptions& options) {
    return {static_cast<int>(panels), window.size(), options.columns, options.width};
}

}  // namespace

Canvas drawSheet(const std::vector<State<2>>& states, const SheetOptions& options) {
    if (states.empty()) throw UserError("no states to draw");
    const Window window = options.window ? *options.window : commonWindow(states);
    const auto draw = [&](Canvas& canvas, const Box& box, const State<2>& state, const PanelStyle<2>& style) {
        drawPanel(canvas, box, window, state, style);
    };
    return sheetOf<2>(states, options, layoutOf(states.size(), window, options), draw);
}

Canvas drawSheet(const std::vector<State<3>>& states, const SheetOptions& options) {
    if (states.empty()) throw UserError("no states to draw");
    const Framing framing = framingOf(states, options.space);
    const Layout layout = layoutOf(states.size(), framing.window, options);
    const auto draw = [&](Canvas& canvas, const Box& box, const State<3>& state, const PanelStyle<3>& style) {
        drawPanel(canvas, box, framing, makeScene(state, style, options.space, framing.camera), style);
    };
    Canvas canvas = sheetOf<3>(states, options, layout, draw);
    const Vec<2> corner(layout.width - 3 * layout.text, layout.height - 1.6 * layout.text);
    drawAxes(canvas, framing.camera, corner, 1.7 * layout.text);
    return canvas;
}

}  // namespace pfem
