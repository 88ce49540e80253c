#include "momentum/rigidInertia.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace pfem {

namespace {

using Type = RigidRestraint::Type;

/// Moment r x f as the last part of a twist.
template <int Dim>
Twist<Dim> wrench(const Vec<Dim>& r, const Vec<Dim>& force) {
    return leverRows<Dim>(r).transpose() * force;
}

/// A moment alone.
template <int Dim>
Twist<Dim> moment(const Eigen::Vector3d& m) {
    Twist<Dim> w = Twist<Dim>::Zero();
    if constexpr (Dim == 2)
        w[2] = m[2];
    else
        w.template tail<3>() = m;
    return w;
}

template <int Dim>
Eigen::Vector3d turning(const Twist<Dim>& twist) {
    if constexpr (Dim == 2)
        return {0, 0, twist[2]};
    else
        return twist.template tail<3>();
}

/// Angular momentum about the centre of mass.
template <int Dim>
Twist<Dim> spinMomentum(const RigidBody<Dim>& body, const Pose<Dim>& pose, const Twist<Dim>& twist) {
    if constexpr (Dim == 2)
        return moment<2>(body.inertia * turning<2>(twist));
    else
        return moment<3>(pose.turn * (body.inertia * (pose.turn.transpose() * turning<3>(twist))));
}

/// Angle that the body has turned about the axis since the reference state, in (-pi, pi].
template <int Dim>
double angleAbout(const Pose<Dim>& pose, const Eigen::Vector3d& axis) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<Dim, Dim>() = pose.turn;
    const Eigen::Quaterniond q(turn);
    const double angle = 2 * std::atan2(q.vec().dot(axis), q.w());
    return std::remainder(angle, 2 * M_PI);
}

/// The body at an end of the step: velocity and place of its points.
template <int Dim>
struct BodyMotion {
    Pose<Dim> pose;
    Twist<Dim> twist;

    Vec<Dim> velocity(const Vec<Dim>& arm) const { return leverRows<Dim>(pose.lever(arm)) * twist; }
};

/// Arm of a place of the reference state.
template <int Dim>
Vec<Dim> armOf(const RigidBody<Dim>& body, const Nodes<Dim>& nodes, const Eigen::Vector3d& place) {
    return place.head<Dim>() - nodes.X[body.nodes[0]] + body.arm[0];
}

/// Force and moment of a restraint in the middle of the step.
template <int Dim>
Twist<Dim> restraining(const RigidRestraint& r, const RigidBody<Dim>& body, const Nodes<Dim>& nodes,
                       const MidpointRule& midpoint, const BodyMotion<Dim>& old, const BodyMotion<Dim>& end) {
    const auto between = [&](const Vec<Dim>& a, const Vec<Dim>& b) { return midpoint.middle<Dim>(a, b); };
    const Vec<Dim> at = between(old.pose.at, end.pose.at);
    const Eigen::Vector3d omega =
        (1 - midpoint.gamma) * turning<Dim>(old.twist) + midpoint.gamma * turning<Dim>(end.twist);
    if (r.type == Type::linearSpring) {
        const Vec<Dim> arm = armOf<Dim>(body, nodes, r.refAttachmentPt);
        const Vec<Dim> place = between(old.pose.place(arm), end.pose.place(arm)), d = place - r.anchor.head<Dim>();
        if (d.norm() == 0) return Twist<Dim>::Zero();
        const Vec<Dim> n = d.normalized(), v = between(old.velocity(arm), end.velocity(arm));
        const double force = -r.stiffness * (d.norm() - r.restLength) - r.damping * v.dot(n);
        if (r.tensionOnly && (d.norm() <= r.restLength || force > 0)) return Twist<Dim>::Zero();
        return wrench<Dim>(place - at, force * n);
    }
    if (r.type == Type::linearDamper) {
        const Vec<Dim> v = between(old.velocity(body.centre), end.velocity(body.centre));
        return wrench<Dim>(between(old.pose.place(body.centre), end.pose.place(body.centre)) - at, -r.coeff * v);
    }
    if (r.type == Type::sphericalAngularDamper) return moment<Dim>(-r.coeff * omega);
    const double before = angleAbout<Dim>(old.pose, r.axis),
                 angle = before + midpoint.gamma * std::remainder(angleAbout<Dim>(end.pose, r.axis) - before, 2 * M_PI);
    return moment<Dim>((-r.stiffness * angle - r.damping * omega.dot(r.axis)) * r.axis);
}

}  // namespace

template <int Dim>
Points<Dim> middleLevers(const Step<Dim>& step, const RigidBody<Dim>& body, const Trial<Dim>& trial, int index) {
    const Pose<Dim> end = body.moved(trial.twist[index], step.dt());
    const Vec<Dim> at = step.midpoint.template middle<Dim>(body.pose.at, end.at);
    Points<Dim> levers;
    for (const int i : body.nodes) levers.push_back(trial.middle.x[i] - at);
    return levers;
}

template <int Dim>
void addRigidInertia(const Step<Dim>& step, const Trial<Dim>& trial, Points<Dim>& R) {
    const auto& bodies = step.constraints.bodies;
    const MidpointRule& midpoint = step.midpoint;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody<Dim>& body = bodies[b];
        const BodyMotion<Dim> old{body.pose, body.twist};
        const Pose<Dim> pose = body.moved(trial.twist[b], midpoint.dt);
        const BodyMotion<Dim> end{pose, body.twistAt(pose, trial.twist[b])};
        const Vec<Dim> force =
            body.mass * ((end.velocity(body.centre) - old.velocity(body.centre)) / midpoint.dt - step.problem.gravity);
        const Vec<Dim> rho = midpoint.template middle<Dim>(old.pose.lever(body.centre), pose.lever(body.centre));
        Twist<Dim> W = wrench<Dim>(rho, force);
        W += (spinMomentum<Dim>(body, pose, end.twist) - spinMomentum<Dim>(body, old.pose, old.twist)) / midpoint.dt;
        for (const auto& restraint : *body.restraints)
            W -= restraining<Dim>(restraint, body, step.old, midpoint, old, end);
        const auto forces = spreadForce<Dim>(middleLevers<Dim>(step, body, trial, static_cast<int>(b)), W);
        for (std::size_t k = 0; k < body.nodes.size(); ++k) R[body.nodes[k]] += forces[k];
    }
}

namespace {

/// A line that is slack now and, as the body moves, after dt.
template <int Dim>
bool isSlack(const RigidRestraint& r, const RigidBody<Dim>& body, const Vec<Dim>& arm, double dt) {
    const Vec<Dim> d = body.pose.place(arm) - r.anchor.head<Dim>();
    const Vec<Dim> later = d + dt * leverRows<Dim>(body.pose.lever(arm)) * body.twist;
    return r.tensionOnly && std::max(d.norm(), later.norm()) <= r.restLength;
}

template <int Dim>
TwistMatrix<Dim> rigidMatrix(const RigidBody<Dim>& body, const Nodes<Dim>& nodes, const MidpointRule& midpoint) {
    TwistMatrix<Dim> A = midpoint.massFactor() * body.massMatrix(body.pose);
    for (const auto& r : *body.restraints) {
        const double spring = 0.5 * midpoint.dt * r.stiffness + r.damping;
        Vec<Dim> arm = body.centre;
        double linear = 0;
        if (r.type == Type::linearSpring) {
            arm = armOf<Dim>(body, nodes, r.refAttachmentPt);
            linear = isSlack<Dim>(r, body, arm, midpoint.dt) ? 0 : spring;
        }
        if (r.type == Type::linearDamper) linear = r.coeff;
        const auto rows = leverRows<Dim>(body.pose.lever(arm));
        A += linear * rows.transpose() * rows;
        const Twist<Dim> axis = moment<Dim>(r.axis);
        if (r.type == Type::linearAxialAngularSpring) A += spring * axis * axis.transpose();
        if (r.type == Type::sphericalAngularDamper)
            A.template bottomRightCorner<nTwist<Dim> - Dim, nTwist<Dim> - Dim>().diagonal().array() += r.coeff;
    }
    return A;
}

}  // namespace

template <int Dim>
void addRigidMatrix(const Step<Dim>& step, SolidBlock<Dim>& block) {
    auto own = block.dofs.bodies.begin();
    for (const auto& body : step.constraints.bodies) {
        if (body.nFree() == 0) continue;
        const Eigen::MatrixXd A = body.free.transpose() * rigidMatrix<Dim>(body, step.old, step.midpoint) * body.free;
        for (int c = 0; c < own->count; ++c)
            for (int d = 0; d <= c; ++d) block.matrix.add(own->first + c, own->first + d, A(c, d));
        ++own;
    }
}

template <int Dim>
void setLevers(const Step<Dim>& step, const Trial<Dim>& trial, SolidDofs<Dim>& dofs) {
    auto own = dofs.bodies.begin();
    for (int b = 0; b < static_cast<int>(trial.twist.size()); ++b) {
        const RigidBody<Dim>& body = step.constraints.bodies[b];
        if (body.nFree() == 0) continue;
        const auto levers = middleLevers<Dim>(step, body, trial, b);
        for (std::size_t k = 0; k < levers.size(); ++k)
            dofs.basis[own->local[k]] = leverRows<Dim>(levers[k]) * body.free;
        ++own;
    }
}

#define PFEM_INSTANTIATE(D)                                                                        \
    template Points<D> middleLevers<D>(const Step<D>&, const RigidBody<D>&, const Trial<D>&, int); \
    template void addRigidInertia<D>(const Step<D>&, const Trial<D>&, Points<D>&);                 \
    template void addRigidMatrix<D>(const Step<D>&, SolidBlock<D>&);                               \
    template void setLevers<D>(const Step<D>&, const Trial<D>&, SolidDofs<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
