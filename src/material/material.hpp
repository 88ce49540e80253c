#pragma once
// Materials by name: constant/materials. The laws are listed in lawTable.cpp.

#include <memory>
#include <string>
#include <vector>

#include "dictionary/dictionary.hpp"
#include "material/newtonian.hpp"
#include "material/solidLaw.hpp"

namespace pfem {

/// Fluid: s = 2 mu (d - tr(d)/3 I) with the law's mu, dp/dt = -kappa div v.
struct ViscousFluid {
    double rho = 1000;     // density [kg/m3]
    double kappa = 2.1e9;  // bulk modulus [Pa]
    std::shared_ptr<const FluidLaw> law = newtonian(1e-3);

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("rho", rho, "kg/m3", "density", positive);
        v("kappa", kappa, "Pa", "bulk modulus", positive);
    }
};

/// Solid: the density, the law, and what the solver's matrices take from it.
struct Solid {
    double rho = 1000;                    // in the reference state [kg/m3]
    IsotropicElasticity elastic;          // the law's elasticity()
    std::shared_ptr<const SolidLaw> law;  // of a material that is a solid: never null

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("rho", rho, "kg/m3", "density in the reference state", positive);
    }
    void setLaw(std::shared_ptr<const SolidLaw> other) {
        law = std::move(other);
        elastic = law->elasticity();
    }
};

enum class MaterialKind { fluid, solid };

/// One named material; only the member of its kind is meaningful.
struct Material {
    std::string name;
    MaterialKind kind = MaterialKind::fluid;
    ViscousFluid fluid;
    Solid solid;
};

/// Read all sub-dictionaries of constant/materials. Throws UserError for unknown types and absurd numbers.
std::vector<Material> readMaterials(const Dictionary& dict);

/// The first of them that is a fluid; null: none.
const ViscousFluid* firstFluid(const std::vector<Material>& all);

/// The material called `name`. Throws UserError with the list of names.
const Material& findMaterial(const std::vector<Material>& all, const std::string& name);

}  // namespace pfem
