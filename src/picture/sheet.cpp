#include "picture/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "picture/colourMap.hpp"
#include "picture/ticks.hpp"

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

ValueRange commonRange(const std::vector<State<2>>& states, const PictureField& field) {
    ValueRange range = rangeOf(states.front(), field);
    for (const auto& state : states) {
        const ValueRange other = rangeOf(state, field);
        range = {std::min(range.low, other.low), std::max(range.high, other.high)};
    }
    if (range.low > range.high) return {0, 1};  // no body has the field
    if (range.low == range.high) return {range.low, range.low + (range.low == 0 ? 1 : std::abs(range.low))};
    return range;
}

/// Sizes of all parts [pixels].
struct Layout {
    double text, gap, label, panelWidth, panelHeight, bar;
    int columns, rows, width, height;

    Layout(int panels, const Vec<2>& window, const SheetOptions& options) {
        columns = std::min(options.columns, panels);
        rows = (panels + columns - 1) / columns;
        width = options.width;
        text = std::clamp(width / 110.0, 8.0, 16.0);  // height of capitals
        gap = 1.4 * text;
        label = 2.2 * text;
        bar = 4.4 * text;
        panelWidth = std::floor((width - (columns + 1) * gap) / columns);
        panelHeight = std::ceil(panelWidth * window[1] / window[0]);
        const double total = rows * (label + panelHeight) + gap + bar;
        if (!(panelWidth >= 20))
            throw UserError(fmt::format("{} columns do not fit into a width of {}", columns, width));
        if (!(panelHeight >= 1 && total <= Canvas::largest && total * width <= 2e8))
            throw UserError(
                fmt::format("the picture would be {} x {:.0f} pixels: choose another box or width", width, total));
        height = static_cast<int>(std::ceil(total));
    }

    Box panel(int k) const {
        const double left = gap + (k % columns) * (panelWidth + gap);
        const double top = label + (k / columns) * (panelHeight + label);
        return {left, top, left + panelWidth, top + panelHeight};
    }
};

void drawColourBar(Canvas& canvas, const Layout& layout, const ValueRange& range, const PictureField& field,
                   const ColourMap& colours) {
    const double length = std::min(0.6 * layout.width, 46 * layout.text), thick = 1.3 * layout.text;
    const double titleWidth = canvas.textWidth(field.title, layout.text);
    const double left = std::max(layout.gap + titleWidth + layout.text, (layout.width - length) / 2);
    const double top = layout.height - layout.bar + 0.6 * layout.text;
    const double right = std::min(left + length, layout.width - 4 * layout.text);
    for (double x = left; x < right; ++x)
        canvas.rectangle({x, top, std::min(x + 1, right), top + thick}, colours((x + 0.5 - left) / (right - left)));
    canvas.text(field.title, {left - layout.text, top + 0.5 * (thick + layout.text)}, layout.text, Align::right);
    for (const double tick : roundTicks(range.low, range.high, 6)) {
        const double x = left + (tick - range.low) / (range.high - range.low) * (right - left);
        canvas.line({x, top + thick}, {x, top + thick + 0.4 * layout.text}, 1, black);
        canvas.text(tickLabel(tick, range.high - range.low), {x, top + thick + 1.9 * layout.text}, layout.text,
                    Align::centre);
    }
}

}  // namespace

Canvas drawSheet(const std::vector<State<2>>& states, const SheetOptions& options) {
    if (states.empty()) throw UserError("no states to draw");
    const PictureField& field = pictureField(options.field);
    const ColourMap colours(options.colours);
    const ValueRange range = options.range ? *options.range : commonRange(states, field);
    const Window window = options.window ? *options.window : commonWindow(states);
    const Layout layout(static_cast<int>(states.size()), window.size(), options);

    Canvas canvas(layout.width, layout.height, options.format);
    PanelStyle style;
    style.field = &field;
    style.range = range;
    style.colourOf = [&](double fraction) { return colours(fraction); };
    style.mesh = options.mesh;
    style.pen = std::max(0.7, layout.panelWidth / 500);
    for (std::size_t k = 0; k < states.size(); ++k) {
        const Box box = layout.panel(static_cast<int>(k));
        drawPanel(canvas, box, window, states[k], style);
        canvas.text(fmt::format("t = {:.6g} s", states[k].time.value), {box.left, box.top - 0.6 * layout.text},
                    layout.text);
    }
    drawColourBar(canvas, layout, range, field, colours);
    return canvas;
}

}  // namespace pfem
