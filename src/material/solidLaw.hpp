#pragma once
// A law of solids that another project adds, in one file:
//
//     class MyLaw : public pfem::SolidLaw { ... };
//     const bool added = pfem::addSolidLaw("myLaw", [](const pfem::Dictionary& dict, const pfem::Hypoelastic& elastic)
//     {
//         return std::unique_ptr<pfem::SolidLaw>(new MyLaw(dict, elastic));
//     });
//
// In constant/materials: `rubber { type myLaw; rho 1200; E 1e6; nu 0.4; ... }`. E and nu make the matrices of the
// iteration, the damper and the compliance that the pressure sees: they should be the law's stiffness at small strain,
// or above it.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/types.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

struct Hypoelastic;

/// Written for three dimensions; two-dimensional cases use it in plane strain. One of the two forms.
class SolidLaw {
public:
    virtual ~SolidLaw() = default;

    /// false: updated(), with stressUpdate rotatedMidpoint; true: total() and energy(), with stressUpdate neoHookean,
    /// that is with all gradients over the reference state.
    virtual bool isTotal() const { return false; }

    /// Cauchy stress after a step [Pa], from the stress before it and the strain of the step, all in the frame halfway
    /// through the step's rotation. (sigma + C : strain is the law `hypoelastic`.) The stress is all that the law may
    /// remember.
    virtual Tensor<3> updated(const Tensor<3>& sigma, const Tensor<3>& strain) const;

    /// Cauchy stress [Pa] and energy per reference volume [J/m3] of the deformation gradient F, det F > 0.
    virtual Tensor<3> total(const Tensor<3>& F) const;
    virtual double energy(const Tensor<3>& F) const;
};

using SolidLawFactory = std::function<std::unique_ptr<SolidLaw>(const Dictionary&, const Hypoelastic&)>;

/// Make `type` known to constant/materials; false when it was known before.
bool addSolidLaw(const std::string& type, SolidLawFactory factory);

std::vector<std::string> addedSolidLaws();

/// The law that a dictionary with an added type asks for.
std::shared_ptr<const SolidLaw> makeSolidLaw(const std::string& type, const Dictionary& dict,
                                             const Hypoelastic& elastic);

/// The law's stress in the stored form of `Dim` dimensions.
template <int Dim>
Stress<Dim> lawMidpoint(const SolidLaw& law, const Stress<Dim>& sigmaOld, const Tensor<Dim>& increment);
template <int Dim>
Stress<Dim> lawTotal(const SolidLaw& law, const Tensor<Dim>& F);
template <int Dim>
double lawEnergy(const SolidLaw& law, const Tensor<Dim>& F);

}  // namespace pfem
