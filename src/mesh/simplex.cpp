#include "mesh/simplex.hpp"

#include <cmath>
#include <limits>

namespace pfem {

template <>
double circumradius<2>(const Points<2>& x, const Simplex<2>& s) {
    const double a = (x[s[1]] - x[s[2]]).norm();
    const double b = (x[s[2]] - x[s[0]]).norm();
    const double c = (x[s[0]] - x[s[1]]).norm();
    const double area = std::abs(simplexMeasure<2>(x, s));
    return area > 0 ? a * b * c / (4 * area) : std::numeric_limits<double>::infinity();
}

template <>
double circumradius<3>(const Points<3>& x, const Simplex<3>& s) {
    const Vec<3> a = x[s[1]] - x[s[0]], b = x[s[2]] - x[s[0]], c = x[s[3]] - x[s[0]];
    const double volume = std::abs(simplexMeasure<3>(x, s));
    if (!(volume > 0)) return std::numeric_limits<double>::infinity();
    const Vec<3> centre = a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b);
    return centre.norm() / (12 * volume);
}

}  // namespace pfem
