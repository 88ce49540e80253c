#include "material/solidLaw.hpp"

#include "base/error.hpp"

namespace pfem {

double SolidLaw::volumePressure(double) const { throw InternalError("a law without volumePressure()"); }
double SolidLaw::volumeEnergy(double) const { throw InternalError("a law without volumeEnergy()"); }
double SolidLaw::shearEnergy(const Tensor<2>&, std::span<const double>) const {
    throw InternalError("a law without shearEnergy()");
}
double SolidLaw::shearEnergy(const Tensor<3>&, std::span<const double>) const {
    throw InternalError("a law without shearEnergy()");
}

}  // namespace pfem
