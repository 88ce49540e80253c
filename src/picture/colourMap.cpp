#include "picture/colourMap.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"

namespace pfem {

namespace {

const std::map<std::string, std::vector<Colour>>& tables() {
    static const std::map<std::string, std::vector<Colour>> all{
        {"viridis",
         {{68, 1, 84},
          {72, 40, 120},
          {62, 74, 137},
          {49, 104, 142},
          {38, 130, 142},
          {31, 158, 137},
          {53, 183, 121},
          {109, 205, 89},
          {180, 222, 44},
          {253, 231, 37}}},
        {"blues", {{214, 230, 244}, {171, 208, 230}, {106, 174, 214}, {56, 138, 193}, {16, 92, 164}, {8, 48, 107}}},
        {"coolWarm",
         {{59, 76, 192},
          {123, 159, 249},
          {192, 212, 245},
          {242, 242, 242},
          {247, 190, 165},
          {226, 105, 82},
          {180, 4, 38}}},
    };
    return all;
}

}  // namespace

const std::vector<std::string>& ColourMap::names() {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> keys;
        for (const auto& [name, points] : tables()) keys.push_back(name);
        return keys;
    }();
    return words;
}

ColourMap::ColourMap(const std::string& name) {
    const auto table = tables().find(name);
    if (table == tables().end()) throw UserError(notValid(name, "colour map", names()));
    points_ = &table->second;
}

Colour ColourMap::operator()(double fraction) const {
    if (!std::isfinite(fraction)) return {150, 150, 150};
    const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(points_->size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), points_->size() - 2);
    const double t = place - static_cast<double>(i);
    Colour colour;
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = static_cast<std::uint8_t>(std::lround((1 - t) * (*points_)[i][c] + t * (*points_)[i + 1][c]));
    return colour;
}

}  // namespace pfem
