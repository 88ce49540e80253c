#pragma once
// Values between two limits to colours.

#include <string>
#include <vector>

#include "picture/image.hpp"

namespace pfem {

class ColourMap {
public:
    /// viridis (dark to bright, even to the eye and readable in grey), blues (light to dark) or
    /// coolWarm (two-sided, light in the middle). Throws UserError with the valid list.
    explicit ColourMap(const std::string& name = "viridis");

    static const std::vector<std::string>& names();

    /// 0 to 1; values beyond take the colour of the end, values that are not finite grey.
    Colour operator()(double fraction) const;

private:
    const std::vector<Colour>* points_;  // at equal distances
};

}  // namespace pfem
