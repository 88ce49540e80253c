#include <algorithm>
#include <limits>

#include "mesher/meshDescription.hpp"
#include "mesher/segmentDistance.hpp"

namespace pfem {

double Refinement::away(const Vec<2>& x) const {
    if (box) return (points[0] - x).cwiseMax(x - points[1]).cwiseMax(Vec<2>::Zero()).norm();
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        least = std::min(least, segmentDistance(x, points[i], points[i + 1]));
    return std::max(0.0, least - distance);
}

double Refinement::area() const {
    if (box) return (points[1] - points[0]).prod();
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        sum += 2 * std::max(distance, meshSize) * (points[i + 1] - points[i]).norm();
    return sum;
}

}  // namespace pfem
