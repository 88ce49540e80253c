#include "material/lawTable.hpp"

#include <algorithm>

#include "material/carreau.hpp"
#include "material/casson.hpp"
#include "material/cross.hpp"
#include "material/granular.hpp"
#include "material/herschelBulkley.hpp"
#include "material/hypoelastic.hpp"
#include "material/j2FinitePlasticity.hpp"
#include "material/j2Plasticity.hpp"
#include "material/mooneyRivlin.hpp"
#include "material/neoHookean.hpp"
#include "material/newtonian.hpp"
#include "material/ogden.hpp"
#include "material/powerLaw.hpp"
#include "material/rigid.hpp"
#include "material/stVenantKirchhoff.hpp"
#include "material/viscoelastic.hpp"
#include "material/yeoh.hpp"

namespace pfem {

namespace {

LawType<SolidLaw> rigidType() {
    LawType<SolidLaw> type{"rigid",
                           "Body that does not deform: it moves and turns as a whole, in one system with fluid and "
                           "solids. Its clamped patch prescribes its motion.",
                           describeEntries<Rigid>(),
                           [](const Dictionary& dict) { return std::make_shared<const Rigid>(readRigid(dict)); }};
    type.entries.push_back({"constraints", "dictionary", "-", "{}",
                            "named sub-dictionaries: type point, line (direction), plane (normal) of the centre of "
                            "rotation; axis (axis), orientation of the turning",
                            ""});
    type.entries.push_back(
        {"restraints", "dictionary", "-", "{}",
         "named sub-dictionaries: type linearSpring (anchor, refAttachmentPt, stiffness, damping, "
         "restLength, tensionOnly), linearDamper (coeff), linearAxialAngularSpring (axis, stiffness, damping), "
         "sphericalAngularDamper (coeff)",
         ""});
    return type;
}

}  // namespace

std::vector<LawType<FluidLaw>>& fluidLaws() {
    static std::vector<LawType<FluidLaw>> all{
        lawType<FluidLaw, Newtonian>("newtonian", "Nearly incompressible viscous fluid."),
        lawType<FluidLaw, Bingham>("bingham",
                                   "Fluid that flows where the shear stress exceeds tau0: mu_eff = tau0 (1 - exp(-m "
                                   "g))/g + mu, g the shear rate."),
        lawType<FluidLaw, HerschelBulkley>("herschelBulkley",
                                           "Fluid with yield stress and shear thinning or thickening: mu_eff = tau0 (1 "
                                           "- exp(-m g))/g + k (g^2 + 1/m^2)^((n-1)/2)."),
        lawType<FluidLaw, PowerLaw>("powerLaw", "Shear thinning or thickening fluid: mu_eff = k g^(n-1), bounded."),
        lawType<FluidLaw, Carreau>("carreau",
                                   "Fluid that thins from mu0 to muInf (Carreau and Yasuda): mu_eff = muInf + (mu0 - "
                                   "muInf) (1 + (lambda g)^a)^((n-1)/a)."),
        lawType<FluidLaw, Cross>("cross",
                                 "Fluid that thins from mu0 to muInf: mu_eff = muInf + (mu0 - muInf)/(1 + (lambda "
                                 "g)^m)."),
        lawType<FluidLaw, Casson>("casson",
                                  "Fluid with yield stress (blood, chocolate): sqrt(tau) = sqrt(tau0) + sqrt(muInf g), "
                                  "tau0 with the factor 1 - exp(-m g)."),
        lawType<FluidLaw, DruckerPrager>("druckerPrager",
                                         "Grains or soil: shear stress cohesion cos(phi) + p sin(phi) + mu g, with the "
                                         "factor 1 - exp(-m g) on the first two."),
        lawType<FluidLaw, MuI>(
            "muI",
            "Dry grains: shear stress mu(I) p, mu(I) = muS + (mu2 - muS)/(1 + I0/I), I = g grainSize "
            "sqrt(grainDensity/p), muS with the factor 1 - exp(-m g)."),
    };
    return all;
}

std::vector<LawType<SolidLaw>>& solidLaws() {
    static std::vector<LawType<SolidLaw>> all{
        lawType<SolidLaw, Hypoelastic>("hypoelastic",
                                       "Isotropic elastic solid, its stress integrated step by step with the rotated "
                                       "midpoint rule: objective."),
        lawType<SolidLaw, HypoelasticPaper>("hypoelasticPaper",
                                            "The same by equation (39) as printed, which forgets that the stress turns "
                                            "with the body: for comparison."),
        lawType<SolidLaw, NeoHookean>("neoHookean",
                                      "Hyperelastic solid, from the reference positions: W = mu/2 (tr b - 3) - mu ln J "
                                      "+ lambda/2 (ln J)^2; at small strain hypoelastic."),
        lawType<SolidLaw, StVenantKirchhoff>("stVenantKirchhoff",
                                             "Hyperelastic solid for large turns and small strains: W = lambda/2 (tr "
                                             "E)^2 + mu E:E with Green's strain E."),
        lawType<SolidLaw, MooneyRivlin>("mooneyRivlin",
                                        "Rubber: W = C10 (I1 - 3) + C01 (I2 - 3) + U(J), I1 and I2 of J^(-2/3) b, U = "
                                        "kappa/4 (J^2 - 1 - 2 ln J)."),
        lawType<SolidLaw, Yeoh>("yeoh",
                                "Rubber that stiffens: W = C1 (I1 - 3) + C2 (I1 - 3)^2 + C3 (I1 - 3)^3 + U(J), as "
                                "mooneyRivlin."),
        lawType<SolidLaw, Ogden>("ogden",
                                 "Rubber: W = sum mu_k/alpha_k (l1^alpha_k + l2^alpha_k + l3^alpha_k - 3) + U(J) with "
                                 "the principal stretches l_i of J^(-1/3) F."),
        lawType<SolidLaw, Viscoelastic>("viscoelastic",
                                        "Rubber with damping: neo-Hookean with E and nu, and beside it springs (shear "
                                        "modulus ratio times that of E and nu) in series with dashpots. Times that are "
                                        "short beside the motion damp it as a viscosity ratio time mu does."),
        lawType<SolidLaw, J2Plasticity>(
            "j2Plasticity",
            "Elastic-plastic metal or clay (von Mises) at small elastic strain, in rates as "
            "hypoelastic: yields at yieldStress + hardening a + (saturationStress - "
            "yieldStress)(1 - exp(-saturationRate a)), a the equivalent plastic strain."),
        lawType<SolidLaw, J2FinitePlasticity>(
            "j2FinitePlasticity",
            "The same at finite strain: F = F_e F_p, elastic energy of the logarithmic "
            "strain."),
        rigidType(),
    };
    return all;
}

namespace lawTableDetail {

namespace {

template <class Law>
bool addTo(std::vector<LawType<Law>>& all, const LawType<Law>& type) {
    const auto same = [&](const auto& known) { return known.name == type.name; };
    if (std::any_of(solidLaws().begin(), solidLaws().end(), same) ||
        std::any_of(fluidLaws().begin(), fluidLaws().end(), same))
        return false;
    all.push_back(type);
    return true;
}

}  // namespace

bool add(const LawType<SolidLaw>& type) { return addTo(solidLaws(), type); }
bool add(const LawType<FluidLaw>& type) { return addTo(fluidLaws(), type); }

}  // namespace lawTableDetail

}  // namespace pfem
