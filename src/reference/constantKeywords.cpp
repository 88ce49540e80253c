#include "reference/keywords.hpp"

namespace pfem {

// What material.cpp, setup.cpp and boundaryConditions.cpp read; a test compares the names.
std::vector<KeywordTable> constantKeywords() {
    const std::string materials = "constant/materials", conditions = "constant/boundaryConditions";
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
        {conditions,
         "",
         "One dictionary per wall and per named patch of system/meshDict.",
         {{"type", "word", "-", "required",
           "slip: fluid slides along the wall; noSlip: it sticks; clamped: the nodes do not move; symmetry: "
           "they slide along the patch; "
           "traction: a loaded edge of a solid",
           "one of: slip noSlip clamped symmetry traction"},
          {"traction", "vector of time", "Pa", "required for traction", "load per area", ""},
          {"friction", "scalar", "-", "0",
           "of a slip wall: shear stress rho c_f |u| u / 2; smooth walls 0.079 Re^(-1/4), Re with 4 times the depth",
           ">= 0"},
          {"motion", "dictionary", "-", "at rest", "how a wall or a clamped patch moves", ""}}},
        {conditions,
         "sideWalls",
         "Walls in front of and behind a plane flow, with friction (2D). Under any name that no patch has.",
         {{"width", "scalar", "m", "required", "their distance", "> 0"},
          {"friction", "scalar", "-", "required",
           "c_f of each, as of slip walls: force per volume - rho c_f |v| v / width", ">= 0"}}},
        {conditions,
         "motion",
         "A rigid motion: a displacement, or a turn about a point that is displaced, or both. Values of time are "
         "written as "
         "OpenFOAM's: constant, table, tableFile, polynomial, sine, square, scale; also expression.",
         {{"displacement", "vector of time", "m", "none", "from the place at time 0", ""},
          {"velocity", "vector of time", "m/s", "none", "instead of displacement", ""},
          {"angle", "scalar of time", "rad", "none", "of the turn since time 0, counter-clockwise", ""},
          {"omega", "scalar of time", "rad/s", "none", "instead of angle", ""},
          {"origin", "vector", "m", "required for a turn", "the point that is turned about, at time 0", ""},
          {"axis", "vector", "-", "(0 0 1)", "of the turn", ""}}},
    };
}

}  // namespace pfem
