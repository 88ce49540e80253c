#pragma once
// Samples with colours and how far away they are.

#include <limits>
#include <vector>

#include "picture/image.hpp"
#include "picture/raster.hpp"

namespace pfem {

/// The nearest of what was put at each sample of some rows.
class Layer {
public:
    explicit Layer(const Rows& rows) : rows_(rows) {
        const auto n = static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.end - rows.first);
        depth_.resize(n, std::numeric_limits<double>::infinity());
        colour_.resize(n, white);
    }
    void put(int x, int y, double depth, Colour colour) {
        if (!(depth < depth_[at(x, y)])) return;
        depth_[at(x, y)] = depth;
        colour_[at(x, y)] = colour;
    }
    double depth(int x, int y) const { return depth_[at(x, y)]; }
    Colour colour(int x, int y) const { return colour_[at(x, y)]; }

private:
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y - rows_.first) * rows_.width + x; }

    Rows rows_;
    std::vector<double> depth_;
    std::vector<Colour> colour_;
};

}  // namespace pfem
