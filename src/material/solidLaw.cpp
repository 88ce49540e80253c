#include "material/solidLaw.hpp"

#include <Eigen/LU>
#include <map>

#include "base/error.hpp"
#include "material/hypoelastic.hpp"

namespace pfem {

namespace {

std::map<std::string, SolidLawFactory>& table() {
    static std::map<std::string, SolidLawFactory> laws;
    return laws;
}

/// In the plane: with `zz` in the third direction.
template <int Dim>
Tensor<3> inSpace(const Tensor<Dim>& t, double zz) {
    Tensor<3> full = Tensor<3>::Zero();
    full(2, 2) = zz;
    full.template topLeftCorner<Dim, Dim>() = t;
    return full;
}

template <int Dim>
Stress<Dim> stored(const Tensor<3>& full) {
    return packStress<Dim>(full.template topLeftCorner<Dim, Dim>(), full(2, 2));
}

template <int Dim>
Tensor<3> deformation(const Tensor<Dim>& F) {
    if (!(F.determinant() > 0)) throw StepFailure("solid turned inside out: deformation gradient with det F <= 0");
    return inSpace<Dim>(F, 1);
}

}  // namespace

Tensor<3> SolidLaw::updated(const Tensor<3>&, const Tensor<3>&) const {
    throw InternalError("a law without updated()");
}
Tensor<3> SolidLaw::total(const Tensor<3>&) const { throw InternalError("a law without total()"); }
double SolidLaw::energy(const Tensor<3>&) const { throw InternalError("a law without energy()"); }

bool addSolidLaw(const std::string& type, SolidLawFactory factory) {
    return table().emplace(type, std::move(factory)).second;
}

std::vector<std::string> addedSolidLaws() {
    std::vector<std::string> names;
    for (const auto& [name, factory] : table()) names.push_back(name);
    return names;
}

std::shared_ptr<const SolidLaw> makeSolidLaw(const std::string& type, const Dictionary& dict,
                                             const Hypoelastic& elastic) {
    return table().at(type)(dict, elastic);
}

template <int Dim>
Stress<Dim> lawMidpoint(const SolidLaw& law, const Stress<Dim>& sigmaOld, const Tensor<Dim>& increment) {
    const Tensor<Dim> half = halfRotation<Dim>(increment);
    const Tensor<Dim> D = 0.5 * (increment + increment.transpose());
    const Tensor<Dim> before = half * stressTensor<Dim>(sigmaOld) * half.transpose();
    const Tensor<3> after = law.updated(inSpace<Dim>(before, sigmaOld[2]), inSpace<Dim>(D, 0));
    const Tensor<Dim> turned = half * after.template topLeftCorner<Dim, Dim>() * half.transpose();
    return packStress<Dim>(turned, after(2, 2));
}

template <int Dim>
Stress<Dim> lawTotal(const SolidLaw& law, const Tensor<Dim>& F) {
    return stored<Dim>(law.total(deformation<Dim>(F)));
}

template <int Dim>
double lawEnergy(const SolidLaw& law, const Tensor<Dim>& F) {
    return law.energy(deformation<Dim>(F));
}

#define PFEM_INSTANTIATE(D)                                                                 \
    template Stress<D> lawMidpoint<D>(const SolidLaw&, const Stress<D>&, const Tensor<D>&); \
    template Stress<D> lawTotal<D>(const SolidLaw&, const Tensor<D>&);                      \
    template double lawEnergy<D>(const SolidLaw&, const Tensor<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
