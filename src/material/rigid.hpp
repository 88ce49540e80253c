#pragma once
// Bodies that do not deform (`type rigid`): what constant/materials says of their mass and of what holds them, in the
// words of OpenFOAM's sixDoFRigidBodyMotion. No stress belongs to them; conditions/rigidBody.hpp moves them.

#include "material/rateLaw.hpp"
#include "material/restraint.hpp"

namespace pfem {

class Rigid : public RateLaw<Rigid> {
public:
    double mass = 0;                       // [kg/m (2D), kg]; 0: density times volume
    std::vector<double> momentOfInertia;   // about the axes through the centre of mass; empty: that of the mesh
    std::vector<double> centreOfMass;      // in the reference state; empty: that of the mesh
    std::vector<double> centreOfRotation;  // what constraints hold; empty: the centre of mass
    std::vector<RigidConstraint> constraints;
    std::vector<RigidRestraint> restraints;

    template <class Visitor>
    void entries(Visitor& v) {
        v("mass", mass, "-", "[kg/m (2D), kg]; 0: density times the volume of the mesh", nonNegative);
        v("momentOfInertia", momentOfInertia, "-",
          "(Ixx Iyy Izz) about the centre of mass [kg m (2D), kg m2]; (): that of the mesh");
        v("centreOfMass", centreOfMass, "-", "(x y z) at the start [m]; (): that of the mesh");
        v("centreOfRotation", centreOfRotation, "-",
          "(x y z) at the start, what constraints hold [m]; (): centreOfMass");
    }
    std::string fault() const {
        for (const auto* list : {&momentOfInertia, &centreOfMass, &centreOfRotation})
            if (!list->empty() && list->size() != 3)
                return "momentOfInertia, centreOfMass and centreOfRotation have three numbers: (x y z)";
        for (const double value : momentOfInertia)
            if (!(value >= 0)) return "momentOfInertia must not be negative";
        return "";
    }
    /// Nominal: matrices leave rigid cells out.
    IsotropicElasticity elasticity() const override { return {1, 0}; }
    Tensor<3> updated(const Tensor<3>&, const Tensor<3>&) const { return Tensor<3>::Zero(); }
};

/// With the sub-dictionaries `constraints` and `restraints`. UserError with file, line and the valid words.
Rigid readRigid(const Dictionary& entry);

/// What the material says when it is rigid, null for others.
inline const Rigid* rigidOf(const SolidLaw* law) { return dynamic_cast<const Rigid*>(law); }

}  // namespace pfem
