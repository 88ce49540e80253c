#include "picture/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "picture/ticks.hpp"

namespace pfem {

Layout::Layout(int panels, const Vec<2>& window, int columnsWanted, int widthWanted) {
    columns = std::min(columnsWanted, panels);
    rows = (panels + columns - 1) / columns;
    width = widthWanted;
    text = std::clamp(width / 110.0, 8.0, 16.0);
    gap = 1.4 * text;
    label = 2.2 * text;
    bar = 4.4 * text;
    panelWidth = std::floor((width - (columns + 1) * gap) / columns);
    panelHeight = std::ceil(panelWidth * window[1] / window[0]);
    const double total = rows * (label + panelHeight) + gap + bar;
    if (!(panelWidth >= 20)) throw UserError(fmt::format("{} columns do not fit into a width of {}", columns, width));
    if (!(panelHeight >= 1 && total <= Canvas::largest && total * width <= 2e8))
        throw UserError(
            fmt::format("the picture would be {} x {:.0f} pixels: choose another box or width", width, total));
    height = static_cast<int>(std::ceil(total));
}

Box Layout::panel(int k) const {
    const int row = k / columns, column = k % columns;
    const double left = gap + column * (panelWidth + gap);
    const double top = label + row * (panelHeight + label);
    return {left, top, left + panelWidth, top + panelHeight};
}

void drawColourBar(Canvas& canvas, const Layout& layout, const ValueRange& range, const std::string& title,
                   const ColourMap& colours) {
    const double length = std::min(0.6 * layout.width, 46 * layout.text), thick = 1.3 * layout.text;
    const double titleWidth = canvas.textWidth(title, layout.text);
    const double left = std::max(layout.gap + titleWidth + layout.text, (layout.width - length) / 2);
    const double top = layout.height - layout.bar + 0.6 * layout.text;
    const double right = std::min(left + length, layout.width - 4 * layout.text);
    for (double x = left; x < right; ++x)
        canvas.rectangle({x, top, std::min(x + 1, right), top + thick}, colours((x + 0.5 - left) / (right - left)));
    canvas.text(title, {left - layout.text, top + 0.5 * (thick + layout.text)}, layout.text, Align::right);
    for (const double tick : roundTicks(range.low, range.high, 6)) {
        const double x = left + (tick - range.low) / (range.high - range.low) * (right - left);
        canvas.line({x, top + thick}, {x, top + thick + 0.4 * layout.text}, 1, black);
        canvas.text(tickLabel(tick, range.high - range.low), {x, top + thick + 1.9 * layout.text}, layout.text,
                    Align::centre);
    }
}

}  // namespace pfem
