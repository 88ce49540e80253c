#include <algorithm>
#include <limits>

#include "mesh/distance.hpp"
#include "mesher/meshDescription.hpp"
#include "state/placeSizes.hpp"

namespace pfem {

double Refinement::away(const Vec<2>& x) const {
    if (box) return distanceToBox<2>(x, points[0], points[1]);
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        least = std::min(least, distanceToSegment<2>(points[i], points[i + 1], x));
    return std::max(0.0, least - distance);
}

double Refinement::area() const {
    if (box) return (points[1] - points[0]).prod();
    const double reach = std::max(distance, meshSize);
    double sum = 4 * reach * reach;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += 2 * reach * (points[i + 1] - points[i]).norm();
    return sum;
}

}  // namespace pfem
