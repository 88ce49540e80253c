#include "picture/ticks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pfem {

std::vector<double> roundTicks(double low, double high, int wanted) {
    const double rough = (high - low) / wanted;
    if (!(rough > 0) || !std::isfinite(rough)) return {low};
    const double decade = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * decade;
    for (const double round : {1.0, 2.0, 2.5, 5.0})
        if (round * decade >= rough) {
            step = round * decade;
            break;
        }
    std::vector<double> ticks;
    const double last = std::floor(high / step + 1e-6);
    for (double k = std::ceil(low / step - 1e-6); k <= last && ticks.size() < 100; ++k) ticks.push_back(k * step);
    return ticks;
}

std::string tickLabel(double value, double scale) {
    return std::abs(value) < 1e-9 * std::abs(scale) ? "0" : fmt::format("{:.6g}", value);
}

}  // namespace pfem
