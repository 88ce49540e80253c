#include "material/herschelBulkley.hpp"

#include <cmath>

#include "material/papanastasiou.hpp"

namespace pfem {

double YieldingFlow::viscosity(double g) const {
    if (!dependsOnFlow()) return k;
    const double flowing = n == 1 ? 1 : std::pow(std::hypot(g, 1 / m), n - 1);
    return tau0 * yieldingTime(m, g) + k * flowing;
}

double YieldingFlow::slope(double g) const {
    if (!dependsOnFlow()) return 0;
    const double flowing = n == 1 ? 0 : (n - 1) * g * std::pow(std::hypot(g, 1 / m), n - 3);
    return tau0 * yieldingTimeSlope(m, g) + k * flowing;
}

}  // namespace pfem
