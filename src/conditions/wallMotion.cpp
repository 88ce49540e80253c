#include "conditions/wallMotion.hpp"

#include <Eigen/Geometry>

namespace pfem {

WallMotion::WallMotion(const Dictionary& dict, bool plane) {
    const auto oneOf = [&](const char* first, const char* second) {
        if (dict.found(first) && dict.found(second))
            dict.fatal(second, std::string("Give either ") + first + " or " + second + ", not both");
    };
    oneOf("displacement", "velocity");
    oneOf("angle", "omega");
    const auto vector = [&](const char* key) {
        return plane ? readPlaneFunction1(dict, key) : readFunction1<Eigen::Vector3d>(dict, key);
    };
    if (dict.found("displacement")) displacement_ = vector("displacement");
    if (dict.found("velocity")) velocity_ = vector("velocity");
    if (dict.found("angle")) angle_ = readFunction1<double>(dict, "angle");
    if (dict.found("omega")) omega_ = readFunction1<double>(dict, "omega");
    if (dict.found("absorb")) absorption_ = readAbsorption(dict, plane);
    if (!displacement_ && !velocity_ && !angle_ && !omega_ && !absorption_)
        throw UserError("A motion needs one of: displacement velocity angle omega absorb", dict.where());
    if (!angle_ && !omega_) return;
    origin_ = dict.get<Eigen::Vector3d>("origin");
    axis_ = dict.get("axis", axis_);
    if (!(axis_.norm() > 0)) dict.fatal("axis", "The axis of rotation must not be zero");
    axis_.normalize();
    if (plane && axis_.head<2>().norm() > 0)
        dict.fatal("axis", "A plane case turns about the z axis only: axis (0 0 1)");
}

Eigen::Vector3d WallMotion::displacement(double t0, double t1) const {
    if (displacement_) return displacement_->value(t1) - displacement_->value(t0);
    return velocity_ ? velocity_->integral(t0, t1) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

double WallMotion::angle(double t0, double t1) const {
    if (angle_) return angle_->value(t1) - angle_->value(t0);
    return omega_ ? omega_->integral(t0, t1) : 0;
}

Eigen::Vector3d WallMotion::velocity(double t) const {
    if (displacement_) return displacement_->derivative(t);
    return velocity_ ? velocity_->value(t) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

template <int Dim>
RigidStep<Dim> WallMotion::step(double t0, double t1) const {
    RigidStep<Dim> s;
    s.from = (origin_ + displacement(0, t0)).head<Dim>();
    s.to = s.from + displacement(t0, t1).head<Dim>();
    s.velocity = velocity(t1).head<Dim>();
    if (!angle_ && !omega_) return s;
    const Eigen::AngleAxisd turn(angle(t0, t1), axis_);
    const Eigen::Vector3d w = (angle_ ? angle_->derivative(t1) : omega_->value(t1)) * axis_;
    Eigen::Matrix3d spin;
    spin << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    s.rotation = turn.toRotationMatrix().topLeftCorner<Dim, Dim>();
    s.spin = spin.topLeftCorner<Dim, Dim>();
    return s;
}

template RigidStep<2> WallMotion::step<2>(double, double) const;
template RigidStep<3> WallMotion::step<3>(double, double) const;

}  // namespace pfem
