#pragma once
// A picture in memory and its colours.

#include <array>
#include <cstdint>
#include <vector>

namespace pfem {

/// Red, green, blue: 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

inline constexpr Colour white{255, 255, 255};
inline constexpr Colour black{0, 0, 0};

/// Pixels row by row from the TOP left corner.
struct Image {
    int width = 0, height = 0;
    std::vector<Colour> pixels;

    Image() = default;
    Image(int w, int h, Colour fill = white)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    Colour& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    const Colour& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

}  // namespace pfem
