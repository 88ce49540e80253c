// Rigid bodies in the momentum matrix: the derivative of what their mass and restraints ask for.

#include "conditions/rigidBodies.hpp"
#include "momentum/rigidInertia.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

PFEM_BOTH_DIMENSIONS(RigidMatrix);

/// A block with corners at (0.1, 0.2) and (0.5, 0.4), in space (0.1, 0.2, 0.3) and (0.5, 0.4, 0.6); its centre of mass
/// elsewhere.
template <int Dim>
CaseOf<Dim> block(const std::string& restraint) {
    const std::string iron = "iron { type rigid; rho 500; centreOfMass (0.25 0.35 " +
                             std::string(Dim == 2 ? "0" : "0.4") + "); " +
                             (restraint.empty() ? "" : "restraints { one { " + restraint + " } }") + " }";
    if constexpr (Dim == 2) {
        return makeCase(
            "meshSize 0.1; bodies ( block { type solid; material iron; " + rectangle(0.1, 0.2, 0.5, 0.4) + " } );",
            iron, "", {0, 0});
    } else {
        TestCase3 c = onLattice(
            {0.1, 0.2, 0.3}, {0.5, 0.4, 0.6}, 0.1, [](const Vec<3>&) { return false; },
            [](const Vec<3>&) { return true; }, water + iron);
        c.problem.gravity.setZero();
        return c;
    }
}

template <int Dim>
struct Body {
    CaseOf<Dim> c;
    MidpointRule midpoint;
    Topology<Dim> topology = c.topology();
    NodeConstraints<Dim> constraints = constraintsOf();

    NodeConstraints<Dim> constraintsOf() const {
        auto all = c.constraints(topology);
        addRigidBodies<Dim>(c.problem, c.state.mesh, c.state.nodes, all);
        return all;
    }
    Step<Dim> step() const { return {c.problem, c.state.mesh, topology, constraints, c.state.nodes, midpoint}; }

    /// Force and moment that the body asks for when it ends the step with the twist u, over gamma.
    Eigen::VectorXd residual(const Twist<Dim>& u) const {
        Trial<Dim> trial = firstTrial<Dim>(step());
        const auto& body = constraints.bodies[0];
        Points<Dim> dv(c.state.nodes.size(), Vec<Dim>::Zero());
        for (std::size_t k = 0; k < body.nodes.size(); ++k)
            dv[body.nodes[k]] = leverRows<Dim>(body.pose.lever(body.arm[k])) * u;
        changeVelocity<Dim>(step(), 1, dv, trial);
        Points<Dim> R(c.state.nodes.size(), Vec<Dim>::Zero());
        addRigidInertia<Dim>(step(), trial, R);
        auto dofs = solidDofs<Dim>(topology.solid, constraints);
        setLevers<Dim>(step(), trial, dofs);
        Eigen::VectorXd W = Eigen::VectorXd::Zero(dofs.n);
        for (std::size_t l = 0; l < dofs.node.size(); ++l) W += dofs.basis[l].transpose() * R[dofs.node[l]];
        return W / midpoint.gamma;
    }
    Eigen::VectorXd slope(const Twist<Dim>& u) const {
        const double eps = 1e-5;
        return (residual(eps * u) - residual(-eps * u)) / (2 * eps);
    }
    SymmetricMatrix matrix() const {
        const auto& nodes = c.state.nodes;
        const auto domains = makeSmoothingDomains<Dim>(c.state.mesh.solid.nodes, topology.solid, nodes.x);
        SolidBlock<Dim> own{solidDofs<Dim>(topology.solid, constraints), {}};
        own.matrix = solidMatrix<Dim>({c.problem, c.controls.solid, c.state.mesh.solid}, domains, own.dofs,
                                      Points<Dim>(nodes.size(), Vec<Dim>::Zero()), nodes.h, midpoint);
        addRigidMatrix<Dim>(step(), own);
        return own.matrix;
    }
};

template <int Dim>
std::vector<Twist<Dim>> someTwists() {
    std::vector<Twist<Dim>> all;
    for (unsigned seed = 1; seed < 6; ++seed) {
        const auto numbers = randomNumbers(nTwist<Dim>, seed);
        all.emplace_back(Eigen::Map<const Twist<Dim>>(numbers.data()));
    }
    return all;
}

// Mass, its lever and moments of inertia; dampers; a spring that turns.
TYPED_TEST(RigidMatrix, isTheDerivative) {
    constexpr int Dim = TypeParam::value;
    for (const std::string restraint : {"", "type linearDamper; coeff 3e3;", "type sphericalAngularDamper; coeff 400;",
                                        "type linearAxialAngularSpring; axis (0 0 1); stiffness 5e4; damping 200;"})
        for (const double gamma : {0.5, 1.0}) {
            const Body<Dim> body{block<Dim>(restraint), {0.01, gamma}}, free{block<Dim>(""), {0.01, gamma}};
            const auto A = body.matrix(), ofMass = free.matrix();
            ASSERT_EQ(A.n, nTwist<Dim>);
            double difference = 0;
            for (const auto& u : someTwists<Dim>()) {
                const Eigen::VectorXd exact = A.multiply(u);
                EXPECT_LT((body.slope(u) - exact).norm(), 1e-6 * exact.norm()) << restraint << " " << gamma;
                difference = std::max(difference, (exact - ofMass.multiply(u)).norm() / exact.norm());
            }
            if (!restraint.empty()) {
                EXPECT_GT(difference, 0.01) << restraint;
            }
        }
}

// A spring at its rest length holds along its line; the matrix holds in all directions, as it will when it turns.
TYPED_TEST(RigidMatrix, ofASpringIsItsDerivativeAlongIt) {
    constexpr int Dim = TypeParam::value;
    const std::string z = Dim == 2 ? "0" : "0.5";
    const Body<Dim> body{block<Dim>("type linearSpring; anchor (1.5 0.4 " + z + "); refAttachmentPt (0.5 0.4 " + z +
                                    "); stiffness 8e5; damping 1e3; restLength 1;"),
                         {0.01, 0.5}},
        free{block<Dim>(""), {0.01, 0.5}};
    const auto A = body.matrix(), ofMass = free.matrix();
    const Vec<Dim> lever = Vec<3>(0.5, 0.4, 0.5).head<Dim>() - body.constraints.bodies[0].pose.at;
    const Eigen::VectorXd alongSpring = leverRows<Dim>(lever).row(0).transpose();
    for (const auto& u : someTwists<Dim>()) {
        const Eigen::VectorXd extra = A.multiply(u) - ofMass.multiply(u), exact = body.slope(u) - free.slope(u);
        // force along x, and its moment
        EXPECT_LT((exact - alongSpring * exact[0]).norm(), 1e-5 * exact.norm());
        EXPECT_NEAR(exact[0], (0.5 * 0.01 * 8e5 + 1e3) * alongSpring.dot(u), 1e-5 * std::abs(exact[0]));
        EXPECT_NEAR(extra[0], exact[0], 1e-5 * std::abs(exact[0]));
        EXPECT_GE(u.dot(extra), u.dot(exact) - 1e-6 * std::abs(u.dot(exact)));
    }
}

}  // namespace
