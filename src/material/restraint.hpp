#pragma once
// What holds a rigid body: constraints take directions of its motion away, restraints are forces on it.

#include <string>
#include <vector>

#include "dictionary/entries.hpp"

namespace pfem {

/// Of the centre of rotation: `point` stays, `line` moves along `direction`, `plane` stays in the plane with `normal`.
/// Of the turning: `axis` only about `axis`, `orientation` none.
struct RigidConstraint {
    enum class Type { point, line, plane, axis, orientation } type;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // unit vector; of point and orientation: none
};

/// `linearSpring`: - stiffness (d - restLength) along the line from `anchor` to the body's point `refAttachmentPt`, d
/// their distance, less damping times the velocity along it; `tensionOnly`: a mooring line, which never pushes.
/// `linearDamper`: - coeff v of the centre of mass. `linearAxialAngularSpring`: moment - stiffness angle - damping rate
/// about `axis`. `sphericalAngularDamper`: - coeff omega.
struct RigidRestraint {
    enum class Type { linearSpring, linearDamper, linearAxialAngularSpring, sphericalAngularDamper } type;
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero(), refAttachmentPt = anchor, axis = Eigen::Vector3d::UnitZ();
    double stiffness = 0, damping = 0, restLength = 0, coeff = 0;
    bool tensionOnly = false;
};

std::vector<RigidConstraint> readRigidConstraints(const Dictionary& all);
std::vector<RigidRestraint> readRigidRestraints(const Dictionary& all);

}  // namespace pfem
