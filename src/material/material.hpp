#pragma once
// Materials by name: constant/materials. One file per law; the table in material.cpp lists them.

#include <memory>
#include <string>
#include <vector>

#include "dictionary/dictionary.hpp"
#include "material/solidLaw.hpp"

namespace pfem {

/// Fluid: s = 2 mu (d - tr(d)/3 I), dp/dt = -kappa div v; mu may depend on the shear rate, see material/viscosity.hpp.
struct ViscousFluid {
    double rho = 1000;             // density [kg/m3]
    double mu = 1e-3;              // dynamic viscosity [Pa s]; with yield stress or exponent the consistency [Pa s^n]
    double kappa = 2.1e9;          // bulk modulus [Pa]
    double yieldStress = 0;        // [Pa]
    double exponent = 1;           // n [-]
    double regularisation = 1000;  // m [s]

    bool isNewtonian() const { return yieldStress == 0 && exponent == 1; }
};

/// Hypoelastic solid: sigma = C : D integrated along the path, isotropic C.
struct Hypoelastic {
    double rho = 1000;                              // density in the reference state [kg/m3]
    double E = 1e6;                                 // Young's modulus [Pa]
    double nu = 0;                                  // Poisson's ratio [-]
    std::shared_ptr<const SolidLaw> law = nullptr;  // instead of C : D

    double lambda() const { return E * nu / ((1 + nu) * (1 - 2 * nu)); }
    double mu() const { return E / (2 * (1 + nu)); }
    double kappa() const { return E / (3 * (1 - 2 * nu)); }
};

enum class MaterialKind { fluid, solid };

/// One named material; only the member of its kind is meaningful.
struct Material {
    std::string name;
    MaterialKind kind = MaterialKind::fluid;
    ViscousFluid fluid;
    Hypoelastic solid;
};

/// Read all sub-dictionaries of constant/materials. Throws UserError for unknown types and absurd numbers.
std::vector<Material> readMaterials(const Dictionary& dict);

/// The material called `name`. Throws UserError with the list of names.
const Material& findMaterial(const std::vector<Material>& all, const std::string& name);

}  // namespace pfem
