#pragma once
// Where the parts of a sheet are: panels, their labels, the colour bar.

#include <string>

#include "picture/colourMap.hpp"
#include "picture/panel.hpp"

namespace pfem {

/// Sizes of all parts [pixels].
struct Layout {
    double text, gap, label, panelWidth, panelHeight, bar;  // text: height of capitals
    int columns, rows, width, height;

    /// `window`: width and height of what a panel shows, in any unit. Throws UserError when it does not fit.
    Layout(int panels, const Vec<2>& window, int columnsWanted, int widthWanted);

    Box panel(int k) const;
};

/// At the sheet's lower end. `title`: the field's, with its unit.
void drawColourBar(Canvas& canvas, const Layout& layout, const ValueRange& range, const std::string& title,
                   const ColourMap& colours);

}  // namespace pfem
