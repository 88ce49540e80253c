#pragma once
// An example of each law of constant/materials, and laws at one point.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <map>

#include "material/hypoelastic.hpp"
#include "material/lawTable.hpp"
#include "material/material.hpp"
#include "material/neoHookean.hpp"

namespace pfem::test {

/// Entries of a solid of each type; what yields does so at 1e3 Pa.
inline const std::map<std::string, std::string> solidSamples{
    {"hypoelastic", "E 2e5; nu 0.3;"},
    {"hypoelasticPaper", "E 2e5; nu 0.3;"},
    {"neoHookean", "E 2e5; nu 0.3;"},
    {"stVenantKirchhoff", "E 2e5; nu 0.3;"},
    {"mooneyRivlin", "C10 3e4; C01 1e4; nu 0.4;"},
    {"yeoh", "C1 4e4; C2 -2e3; C3 500; nu 0.4;"},
    {"ogden", "mu (6e4 1e2 -1e4); alpha (1.3 5 -2); nu 0.4;"},
    {"viscoelastic", "E 2e5; nu 0.4; ratios (0.5 2); times (0.1 10);"},
    {"j2Plasticity", "E 2e5; nu 0.3; yieldStress 1e3; hardening 1e4; saturationStress 2e3; saturationRate 50;"},
    {"j2FinitePlasticity", "E 2e5; nu 0.3; yieldStress 1e3; hardening 1e4; saturationStress 2e3; saturationRate 50;"},
};

/// Entries of a fluid of each type.
inline const std::map<std::string, std::string> fluidSamples{
    {"newtonian", "mu 3;"},
    {"bingham", "mu 3; tau0 50; m 100;"},
    {"herschelBulkley", "k 7; n 0.4; tau0 50; m 100;"},
    {"powerLaw", "k 7; n 0.4; muMin 0.01; muMax 1e5;"},
    {"carreau", "mu0 5; muInf 0.1; lambda 2; n 0.3;"},
    {"cross", "mu0 5; muInf 0.1; lambda 2; m 0.8;"},
    {"casson", "muInf 2; tau0 50; m 100;"},
    {"druckerPrager", "frictionAngle 30; cohesion 20; mu 1; m 100;"},
    {"muI", "muS 0.38; mu2 0.64; I0 0.3; grainSize 5e-4; grainDensity 2500; muMin 0.01; m 100;"},
};

inline Material materialOf(const std::string& type, const std::string& entries) {
    return readMaterials(Dictionary::parse("a { type " + type + "; rho 1000; " + entries + " }", "materials"))[0];
}

/// A solid's law at one point.
template <int Dim>
class LawAtPoint {
public:
    LawAtPoint(const std::string& type, const std::string& entries) : LawAtPoint(materialOf(type, entries).solid.law) {}
    explicit LawAtPoint(std::shared_ptr<const SolidLaw> of) : law(std::move(of)), history(law->historyAtStart()) {}

    std::shared_ptr<const SolidLaw> law;
    std::vector<double> history;
    Stress<Dim> sigma = Stress<Dim>::Zero();
    bool isTotal() const { return law->kinematics() == Kinematics::reference; }

    /// Go from F0 to F1 in a step of dt; returns the whole stress.
    Stress<Dim> go(const Tensor<Dim>& F0, const Tensor<Dim>& F1, double dt = 1) {
        const Tensor<Dim> along = law->kinematics() == Kinematics::endPoint ? F1 : Tensor<Dim>(0.5 * (F0 + F1));
        Tensor<Dim> gradient = isTotal() ? F1 : Tensor<Dim>((F1 - F0) * along.inverse());
        if (law->kinematics() == Kinematics::endPoint) gradient /= dt;
        const std::vector<double> before = history;
        law->stress(SolidPoints<Dim>{{&gradient, 1}, {&sigma, 1}, before, history, dt});
        return isTotal() ? withPressure<Dim>(sigma, law->volumePressure(F1.determinant())) : sigma;
    }
};

}  // namespace pfem::test
