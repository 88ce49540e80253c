#include "material/viscosity.hpp"

#include <cmath>

namespace pfem {

template <int Dim>
double shearRate(const Tensor<Dim>& L) {
    const Tensor<Dim> d = 0.5 * (L + L.transpose());
    return std::sqrt(std::max(2 * (d.squaredNorm() - d.trace() * d.trace() / 3), 0.0));
}

template double shearRate<2>(const Tensor<2>&);
template double shearRate<3>(const Tensor<3>&);

}  // namespace pfem
