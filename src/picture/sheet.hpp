#pragma once
// Several times side by side in one picture, with time labels and a colour bar.

#include <optional>
#include <string>
#include <vector>

#include "picture/scene.hpp"

namespace pfem {

struct SheetOptions {
    std::string field;  // default: p; in space vonMises, U without solids
    std::string colours = "viridis";
    std::optional<ValueRange> range;  // default: of all states
    std::optional<Window> window;     // in the plane; default: of all states, with a margin
    int columns = 3;
    int width = 1600;  // [pixels]
    bool mesh = false;
    PictureFormat format = PictureFormat::png;
    SpaceOptions space;
};

/// The panels in reading order. Throws UserError when there is nothing to draw or the options make no sense.
Canvas drawSheet(const std::vector<State<2>>& states, const SheetOptions& options);
Canvas drawSheet(const std::vector<State<3>>& states, const SheetOptions& options);

}  // namespace pfem
