#include "mesh/simplex.hpp"

#include <cmath>
#include <limits>

namespace pfem {

double circumradius(const Points<2>& x, const Simplex<2>& s) {
    const double a = (x[s[1]] - x[s[2]]).norm();
    const double b = (x[s[2]] - x[s[0]]).norm();
    const double c = (x[s[0]] - x[s[1]]).norm();
    const double area = std::abs(simplexMeasure<2>(x, s));
    return area > 0 ? a * b * c / (4 * area) : std::numeric_limits<double>::infinity();
}

}  // namespace pfem
