#pragma once
// The assembled momentum matrix of the solid nodes, interface included (41)-(42).

#include <memory>

#include "conditions/problem.hpp"
#include "integration/midpointRule.hpp"
#include "integration/stressPoints.hpp"
#include "linear/symmetricSolver.hpp"
#include "momentum/solids.hpp"

namespace pfem {

/// Velocity unknowns of the solid nodes: free nodes have Dim, sliding nodes Dim - 1, fixed ones none. The nodes of a
/// rigid body share those of the body, which come after all others.
template <int Dim>
struct SolidDofs {
    using Directions = Eigen::Matrix<double, Dim, Eigen::Dynamic, 0, Dim, nTwist<Dim>>;
    struct Body {
        int first, count;
        std::vector<int> local;  // of its nodes: indices into `node`
    };

    std::vector<int> node;              // solid nodes with unknowns
    std::vector<int> first;             // per mesh node: its first unknown or -1
    std::vector<int> count;             // per mesh node
    std::vector<Directions> basis;      // per entry of `node`: the velocity of each of its unknowns
    std::vector<unsigned char> isFree;  // per entry of `node`: are they those along the axes?
    std::vector<int> local;             // per mesh node: index into `node` or -1
    std::vector<Body> bodies;           // those with unknowns
    int n = 0;

    bool ofBody(int i) const { return local[i] >= 0 && !bodies.empty() && first[i] >= bodies[0].first; }
};

/// The momentum matrix of the solids' velocities.
template <int Dim>
struct SolidBlock {
    SolidDofs<Dim> dofs;
    SymmetricMatrix matrix;
    std::shared_ptr<const SymmetricSolver> factor = nullptr;  // of the matrix, once MomentumSystem has made it
};

template <int Dim>
SolidDofs<Dim> solidDofs(const NodeToCells& solid, const NodeConstraints<Dim>& constraints);

/// A_s = inertia (surfaceStiffness.hpp) + (c - tau_s) K_points + tau_s K_element,  K = sum Omega G^T C G,
/// c = dt (laws of the kind endPoint) or dt/2; the inertia of solid and fluid together. With elemental integration both
/// K are one. velocityPressure: c K_points has C less its volumetric part alone (deviatoric for laws in rates), the
/// nodal domains give that, volumeModulus I (x) I.
template <int Dim>
SymmetricMatrix solidMatrix(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains, const SolidDofs<Dim>& dofs,
                            const Points<Dim>& inertia, const std::vector<double>& h, const MidpointRule& midpoint);

}  // namespace pfem
