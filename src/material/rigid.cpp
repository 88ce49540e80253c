#include "material/rigid.hpp"

#include "material/lawEntries.hpp"

namespace pfem {

namespace {

/// A direction of any length but zero, as a unit vector.
Eigen::Vector3d unitVector(const Dictionary& dict, const std::string& key) {
    const auto u = dict.get<Eigen::Vector3d>(key);
    if (!(u.norm() > 0)) dict.fatal(key, "Entry '" + key + "' must not be zero");
    return u.normalized();
}

double atLeastZero(const Dictionary& dict, const std::string& key, double value) {
    if (!(value >= 0)) dict.fatal(key, "Entry '" + key + "' must not be negative");
    return value;
}

}  // namespace

std::vector<RigidConstraint> readRigidConstraints(const Dictionary& all) {
    using Type = RigidConstraint::Type;
    std::vector<RigidConstraint> result;
    for (const auto& name : all.keys()) {
        const Dictionary& entry = all.subDict(name);
        const std::string type = entry.choice("type", {"point", "line", "plane", "axis", "orientation"});
        if (type == "point") result.push_back({Type::point});
        if (type == "line") result.push_back({Type::line, unitVector(entry, "direction")});
        if (type == "plane") result.push_back({Type::plane, unitVector(entry, "normal")});
        if (type == "axis") result.push_back({Type::axis, unitVector(entry, "axis")});
        if (type == "orientation") result.push_back({Type::orientation});
    }
    return result;
}

std::vector<RigidRestraint> readRigidRestraints(const Dictionary& all) {
    using Type = RigidRestraint::Type;
    std::vector<RigidRestraint> result;
    for (const auto& name : all.keys()) {
        const Dictionary& entry = all.subDict(name);
        const std::string type = entry.choice(
            "type", {"linearSpring", "linearDamper", "linearAxialAngularSpring", "sphericalAngularDamper"});
        RigidRestraint r{Type::linearSpring};
        const bool spring = type == "linearSpring", angular = type == "linearAxialAngularSpring";
        if (spring || angular) {
            r.stiffness = atLeastZero(entry, "stiffness", entry.get<double>("stiffness"));
            r.damping = atLeastZero(entry, "damping", entry.get<double>("damping", 0));
        }
        if (spring) {
            r.anchor = entry.get<Eigen::Vector3d>("anchor");
            r.refAttachmentPt = entry.get<Eigen::Vector3d>("refAttachmentPt");
            r.restLength = atLeastZero(entry, "restLength", entry.get<double>("restLength", 0));
            r.tensionOnly = entry.get<bool>("tensionOnly", false);
        } else if (angular) {
            r.type = Type::linearAxialAngularSpring;
            r.axis = unitVector(entry, "axis");
        } else {
            r.type = type == "linearDamper" ? Type::linearDamper : Type::sphericalAngularDamper;
            r.coeff = atLeastZero(entry, "coeff", entry.get<double>("coeff"));
        }
        result.push_back(r);
    }
    return result;
}

Rigid readRigid(const Dictionary& entry) {
    auto rigid = readLaw<Rigid>(entry);
    rigid.constraints = readRigidConstraints(entry.subDictOrEmpty("constraints"));
    rigid.restraints = readRigidRestraints(entry.subDictOrEmpty("restraints"));
    return rigid;
}

}  // namespace pfem
