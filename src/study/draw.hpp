#pragma once
// Pictures of studies, drawn by gnuplot.

#include <filesystem>
#include <string>

namespace pfem {

/// Run gnuplot on <name>.gp in `folder`, its words to log.gnuplot. Without gnuplot, or when it cannot draw, a warning
/// on stderr says how to draw it later.
void drawPicture(const std::filesystem::path& folder, const std::string& name);

}  // namespace pfem
