#pragma once
// What the solver asks of the law of a solid. A law is one class with its entries and its formula; it derives from
// RateLaw (rateLaw.hpp: stress from the stress before and the strain of the step) or from HyperelasticLaw
// (hyperelasticLaw.hpp: stress from the deformation gradient), and is made known by a line in lawTable.cpp or, in a
// project of one's own, by addSolidLaw (lawTable.hpp).

#include <span>
#include <string>
#include <vector>

#include "base/types.hpp"
#include "material/elasticity.hpp"

namespace pfem {

/// Which gradients a law takes its stress from.
enum class Kinematics {
    midpoint,  // of the step's displacement over (x^n + x)/2
    endPoint,  // of the velocity over x, both at the end of the step: equation (39) as printed
    reference  // of x over the reference positions X: the deformation gradient F
};

/// Stress points of one material, one after the other: what a law is asked for in one call.
template <int Dim>
struct SolidPoints {
    std::span<const Tensor<Dim>> gradient;  // see Kinematics; 2D is plane strain
    std::span<Stress<Dim>> sigma;    // in: at the start of the step (not `reference`); out: the law's stress [Pa]
    std::span<const double> before;  // what the law remembered at the start of the step, one point's numbers after
                                     // the other's
    std::span<double> history;       // out: at its end
    double dt = 0;                   // [s]

    int size() const { return static_cast<int>(gradient.size()); }
};

class SolidLaw {
public:
    virtual ~SolidLaw() = default;

    virtual Kinematics kinematics() const = 0;

    /// At small strain: of the matrices of the iteration, the damper, the compliance that the pressure of the fluid
    /// sees. The law's own stiffness, or above it.
    virtual IsotropicElasticity elasticity() const = 0;

    /// Names of the numbers that the law remembers at each stress point, and their values before anything has happened.
    virtual std::vector<std::string> historyNames() const { return {}; }
    virtual std::vector<double> historyAtStart() const { return std::vector<double>(historyNames().size(), 0.0); }

    /// Kinematics midpoint and endPoint: the Cauchy stress at the end of the step. reference: the part of it that is
    /// not pressure(J); the whole is shear - pressure(det F) I.
    virtual void stress(const SolidPoints<2>& points) const = 0;
    virtual void stress(const SolidPoints<3>& points) const = 0;

    /// The stress that the step makes with elasticity() alone: velocityPressure takes the nodal pressure from it. (Not
    /// `reference`; the history is not there.)
    virtual void predict(const SolidPoints<2>& points) const { stress(points); }
    virtual void predict(const SolidPoints<3>& points) const { stress(points); }

    /// Kinematics `reference`: the volumetric part, p = - dU/dJ [Pa] of the ratio of volumes J, U per reference volume
    /// [J/m3]; and d^2U/dJ^2 at J = 1 [Pa]. velocityPressure takes J from the volumes of the nodes. The others: kappa.
    virtual double volumePressure(double J) const;
    virtual double volumeEnergy(double J) const;
    virtual double volumeModulus() const { return elasticity().kappa(); }

    /// Kinematics `reference`: the stored energy of `stress`, per reference volume [J/m3].
    virtual double shearEnergy(const Tensor<2>& F, std::span<const double> history) const;
    virtual double shearEnergy(const Tensor<3>& F, std::span<const double> history) const;
};

/// Gives the functions of both dimensions from Law::stressOf<Dim>(points).
template <class Law>
class SolidLawOf : public SolidLaw {
public:
    void stress(const SolidPoints<2>& points) const final { law().template stressOf<2>(points); }
    void stress(const SolidPoints<3>& points) const final { law().template stressOf<3>(points); }

protected:
    const Law& law() const { return static_cast<const Law&>(*this); }
};

/// The part of one point of a span that holds `width` numbers of each point.
template <class T>
std::span<T> ofPoint(std::span<T> all, int width, int point) {
    return all.subspan(static_cast<std::size_t>(width) * static_cast<std::size_t>(point),
                       static_cast<std::size_t>(width));
}

}  // namespace pfem
