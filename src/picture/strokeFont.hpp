#pragma once
// Text on a canvas, drawn as strokes: no font file is needed.

#include <string>

#include "picture/canvas.hpp"

namespace pfem {

enum class Align { left, centre, right };

/// `at`: the baseline's left end, middle or right end; `size`: height of a capital letter [pixels].
/// Characters beyond ASCII's letters, digits and usual signs appear as boxes.
void drawText(Canvas& canvas, const std::string& text, const Vec<2>& at, double size, Align align = Align::left,
              Colour colour = black, double weight = 1);

/// [pixels]
double textWidth(const std::string& text, double size);

}  // namespace pfem
