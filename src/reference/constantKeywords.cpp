#include "reference/keywords.hpp"

namespace pfem {

// What material.cpp and setup.cpp read; a test compares the names.
std::vector<KeywordTable> constantKeywords() {
    const std::string materials = "constant/materials";
    const EntryDescription rho{"rho", "scalar", "kg/m3", "required", "density, of solids in the reference state",
                               "> 0"};
    const EntryDescription kappa{"kappa", "scalar", "Pa", "2100000000", "bulk modulus", "> 0"};
    const EntryDescription yieldStress{"tau0", "scalar", "Pa", "required", "yield stress; 0: none", ">= 0"};
    const EntryDescription regularisation{
        "m",  "scalar", "s", "1000", "Papanastasiou's time: shear rates below 1/m creep with the viscosity m tau0",
        "> 0"};
    return {
        {materials,
         "",
         "One dictionary per material under its name. Dimensions [..] may stand before a value and are "
         "checked.",
         {{"type", "word", "-", "required", "the law", "one of: newtonian bingham herschelBulkley hypoelastic"}}},
        {materials,
         "newtonian",
         "Nearly incompressible viscous fluid.",
         {rho, {"mu", "scalar", "Pa s", "required", "dynamic viscosity", ">= 0"}, kappa}},
        {materials,
         "bingham",
         "Fluid that flows where the shear stress exceeds tau0: mu_eff = tau0 (1 - exp(-m g))/g + mu, g the shear "
         "rate.",
         {rho, {"mu", "scalar", "Pa s", "required", "plastic viscosity", ">= 0"}, yieldStress, regularisation, kappa}},
        {materials,
         "herschelBulkley",
         "Fluid with yield stress and shear thinning or thickening: mu_eff = tau0 (1 - exp(-m g))/g + k (g^2 + "
         "1/m^2)^((n-1)/2).",
         {rho,
          {"k", "scalar", "Pa s^n", "required", "consistency", "> 0"},
          {"n", "scalar", "-", "required", "flow index: below 1 shear thinning, above 1 thickening", "> 0"},
          yieldStress,
          regularisation,
          kappa}},
        {materials,
         "hypoelastic",
         "Isotropic elastic solid; also for stressUpdate neoHookean.",
         {rho,
          {"E", "scalar", "Pa", "required", "Young's modulus", "> 0"},
          {"nu", "scalar", "-", "required", "Poisson's ratio", "> -1 and < 0.5"}}},
        {"constant/g",
         "",
         "Gravity.",
         {{"dimensions", "dimensions", "-", "optional", "checked: [0 1 -2 0 0 0 0]", ""},
          {"value", "vector of time", "m/s2", "required", "acceleration of gravity", ""}}},
    };
}

}  // namespace pfem
