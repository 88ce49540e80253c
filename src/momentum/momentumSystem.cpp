#include "momentum/momentumSystem.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "base/parallel.hpp"
#include "linear/conjugateGradients.hpp"
#include "linear/solvers.hpp"
#include "momentum/consistentMass.hpp"

namespace pfem {

namespace {

/// rho h^2/dt with h^2 = Omega^{2/Dim}: an acoustic Courant number of one at each stress point [Pa s].
template <int Dim>
PerPoint<double> localBulk(const FluidPhase<Dim>& fluid, double dt) {
    const SmoothingDomains<Dim>& domains = fluid.domains;
    PerPoint<double> bulk(nStressPoints<Dim>(domains), 0.0);
    for (int p = 0; p < nStressPoints<Dim>(domains); ++p) {
        if (!isStressPoint<Dim>(domains, p)) continue;
        const double rho = fluid.problem.fluid(fluid.cells.material[cellOfPoint<Dim>(domains, p)]).rho;
        bulk[p] = rho * std::pow(pointVolume<Dim>(domains, p), 2.0 / Dim) / dt;
    }
    return bulk;
}

/// About the diagonal of the viscous matrix: at most sum_e 2 mu |e| |grad N_I|^2.
template <int Dim>
PerNode<double> viscousDiagonal(const SmoothingDomains<Dim>& fluid, const PerCell<double>& cellMu) {
    PerNode<double> diagonal(fluid.nNodes(), 0.0);
    const NodeToCells& around = *fluid.around;
    fluid.share.forNodes(fluid.nNodes(), [&](int i) {
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const auto& g = fluid.element[around.cell[s]];
            diagonal[i] += 2 * cellMu[around.cell[s]] * g.measure * g.gradN[around.corner[s]].squaredNorm();
        }
    });
    fluid.share.gather(diagonal);
    return diagonal;
}

/// Ratios of the viscous matrix's diagonal to that of the mass: the largest, and the one that nodes with a thousandth
/// of the mass exceed, to the next power of two.
struct Ratios {
    double largest = 0, typical = 0;
};
Ratios viscousRatios(const std::vector<double>& viscous, const std::vector<double>& massDiagonal) {
    constexpr double part = 1e-3;
    Ratios ratios;
    std::map<int, double, std::greater<>> massAbove;  // per binary exponent of the ratio
    double mass = 0, above = 0;
    for (std::size_t i = 0; i < viscous.size(); ++i) {
        if (!(massDiagonal[i] > 0 && viscous[i] > 0)) continue;
        const double ratio = std::min(viscous[i] / massDiagonal[i], 1e30);
        ratios.largest = std::max(ratios.largest, ratio);
        massAbove[std::ilogb(ratio)] += massDiagonal[i];
        mass += massDiagonal[i];
    }
    for (const auto& [exponent, amount] : massAbove) {
        above += amount;
        if (above <= part * mass) continue;
        ratios.typical = std::ldexp(1.0, exponent + 1);
        break;
    }
    return ratios;
}

/// One value for all points: mean diagonal of the mass matrix over that of sum_e |e| grad N_I . grad N_I / Dim.
template <int Dim>
PerPoint<double> meanBulk(const SmoothingDomains<Dim>& fluid, const PerNode<double>& inertia) {
    double massSum = 0, gradientSum = 0;
    for (int i = 0; i < fluid.nNodes(); ++i) massSum += inertia[i];
    for (const auto& g : fluid.element)
        for (const auto& gradN : g.gradN) gradientSum += g.measure * gradN.squaredNorm() / Dim;
    return PerPoint<double>(nStressPoints<Dim>(fluid), gradientSum > 0 ? massSum / gradientSum : 0);
}

/// Where the unknowns of a solid are: at their nodes.
template <int Dim>
Places<Dim> placesOfUnknowns(const SolidDofs<Dim>& dofs, const Points<Dim>& x) {
    Places<Dim> place(dofs.n);
    for (const int i : dofs.node)
        for (int c = 0; c < dofs.count[i]; ++c) place[dofs.first[i] + c] = x[i];
    return place;
}

/// The largest ratio of an entry of the solids' diagonal to the inertia in it.
template <int Dim>
double largestStiffness(const SolidBlock<Dim>& solid, const Points<Dim>& inertia) {
    const SolidDofs<Dim>& dofs = solid.dofs;
    double largest = 0;
    for (std::size_t k = 0; k < dofs.node.size(); ++k) {
        const int i = dofs.node[k];
        if (dofs.ofBody(i)) continue;
        for (int c = 0; c < dofs.count[i]; ++c)
            largest = std::max(largest, solid.matrix.value[solid.matrix.start[dofs.first[i] + c]] /
                                            inertia[i].dot(dofs.basis[k].col(c).cwiseAbs2()));
    }
    return largest;
}

}  // namespace

template <int Dim>
MomentumSystem<Dim>::MomentumSystem(const Step<Dim>& step, const MomentumControls& controls,
                                    const FluidPhase<Dim>& fluid, const Points<Dim>& inertia, SolidBlock<Dim> solid)
    : controls_(controls),
      step_(step),
      constraints_(step.constraints),
      fluid_(fluid),
      solid_(std::move(solid)),
      massFactor_(step.midpoint.massFactor()),
      moving_(inertia.size(), 0),
      inertia_(inertia.size(), Vec<Dim>::Zero()),
      diagonal_(inertia.size(), 0.0) {
    if (solid_.dofs.n > 0) {
        auto solver = elasticSolver<Dim>(solid_.matrix, placesOfUnknowns<Dim>(solid_.dofs, step.old.x),
                                         largestStiffness<Dim>(solid_, inertia));
        solver->analyse(solid_.matrix);
        solver->factor(solid_.matrix);
        solid_.factor = std::move(solver);
    }
    const Topology<Dim>& topology = step.topology;
    for (int i = 0; i < topology.nNodes(); ++i) {
        moving_[i] = topology.wet(i) && !topology.onSolid[i] && !step.isImage(i) && constraints_.freedom[i].any();
    }
    setInertia(inertia);
    updateViscosity();
    if (controls_.theta > 0) {
        bulk_ =
            controls_.bulkRule == "local" ? localBulk<Dim>(fluid, step.dt()) : meanBulk<Dim>(fluid.domains, diagonal_);
        for (double& value : bulk_) value *= controls_.theta;
    }
}

template <int Dim>
void MomentumSystem<Dim>::updateViscosity() {
    viscousDiagonal_ = viscousDiagonal<Dim>(fluid_.domains, fluid_.mu);
    const Ratios ratios = viscousRatios(viscousDiagonal_, diagonal_);
    viscousNumber_ = ratios.typical;
    // light nodes on flat triangles do not make the whole fluid a thick one as long as the diagonal alone converges
    // there
    viscous_ =
        controls_.theta > 0 || ratios.typical > controls_.viscousLimit || ratios.largest > 30 * controls_.viscousLimit;
    parallelFor(static_cast<int>(diagonal_.size()), [&](int i) {
        if (!viscous_ && viscousDiagonal_[i] <= controls_.viscousLimit * diagonal_[i]) viscousDiagonal_[i] = 0;
    });
}

template <int Dim>
void MomentumSystem<Dim>::setInertia(const Points<Dim>& inertia) {
    parallelFor(static_cast<int>(inertia.size()), [&](int i) {
        if (!moving_[i]) return;
        inertia_[i] = inertia[i];
        const Freedom<Dim>& freedom = constraints_.freedom[i];
        if (!freedom.all()) {  // the mean over the directions in which it can move
            Vec<Dim> free = Vec<Dim>::Zero();
            for (int c = 0; c < freedom.count; ++c) free += freedom.basis.col(c).cwiseAbs2();
            inertia_[i].setConstant(inertia[i].dot(free) / freedom.count);
        }
        diagonal_[i] = inertia_[i].minCoeff();
    });
}

template <int Dim>
Eigen::VectorXd MomentumSystem<Dim>::gather(const Points<Dim>& r) const {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(solid_.dofs.n);
    for (std::size_t k = 0; k < solid_.dofs.node.size(); ++k)
        for (int c = 0; c < solid_.dofs.count[solid_.dofs.node[k]]; ++c)
            u[solid_.dofs.first[solid_.dofs.node[k]] + c] += solid_.dofs.basis[k].col(c).dot(r[solid_.dofs.node[k]]);
    return u;
}

/// (B^T B)^-1 f on the rigid bodies' unknowns: from the nodes' velocities gathered to those of the bodies.
template <int Dim>
Eigen::VectorXd MomentumSystem<Dim>::perBody(Eigen::VectorXd f) const {
    for (std::size_t b = 0; b < ofBody_.size(); ++b) {
        const auto& body = solid_.dofs.bodies[b];
        f.segment(body.first, body.count) = (ofBody_[b] * f.segment(body.first, body.count)).eval();
    }
    return f;
}

/// Forces on rigid bodies' nodes become the least ones that do the same to the bodies: what conjugate gradients see of
/// them, as of a velocity, is then a vector of the bodies' unknowns.
template <int Dim>
void MomentumSystem<Dim>::spreadOverBodies(Points<Dim>& force) const {
    if (ofBody_.empty()) return;
    Eigen::VectorXd onBodies = perBody(gather(force));
    onBodies.head(solid_.dofs.bodies[0].first).setZero();  // they come last
    for (const auto& body : solid_.dofs.bodies)
        for (const int l : body.local) force[solid_.dofs.node[l]].setZero();
    scatter(onBodies, force);
}

template <int Dim>
Eigen::VectorXd MomentumSystem<Dim>::onSolids(const std::vector<std::pair<int, Vec<Dim>>>& forces) const {
    const SolidDofs<Dim>& dofs = solid_.dofs;
    Eigen::VectorXd f = Eigen::VectorXd::Zero(dofs.n);
    for (const auto& [node, force] : forces)
        if (dofs.local[node] >= 0)
            f.segment(dofs.first[node], dofs.count[node]) += dofs.basis[dofs.local[node]].transpose() * force;
    return f;
}

template <int Dim>
void MomentumSystem<Dim>::scatter(const Eigen::VectorXd& u, Points<Dim>& r) const {
    for (std::size_t k = 0; k < solid_.dofs.node.size(); ++k) {
        Vec<Dim>& value = r[solid_.dofs.node[k]];
        for (int c = 0; c < solid_.dofs.count[solid_.dofs.node[k]]; ++c)
            value += u[solid_.dofs.first[solid_.dofs.node[k]] + c] * solid_.dofs.basis[k].col(c);
    }
}

template <int Dim>
Points<Dim> MomentumSystem<Dim>::restricted(Points<Dim> r) const {
    parallelFor(static_cast<int>(r.size()), [&](int i) {
        const bool moves = diagonal_[i] > 0 || solid_.dofs.local[i] >= 0;
        r[i] = moves ? constraints_.project(i, r[i]) : Vec<Dim>(Vec<Dim>::Zero());
    });
    return r;
}

template <int Dim>
void MomentumSystem<Dim>::addOfFluid(Points<Dim> u, Points<Dim>& force) const {
    step_.follow(u);
    carryRiders<Dim>(constraints_.riders, u);
    if (viscous_)
        addInternalForce<Dim>(fluid_.domains, fluidTangentStress<Dim>(fluid_.domains, fluid_.viscosity, u, bulk_),
                              force);
    if (isConsistent()) addMassDifference<Dim>(fluid_, massFactor_, u, force);
    fluid_.domains.share.gather(force);
    handOver<Dim>(constraints_.riders, force);
}

template <int Dim>
Points<Dim> MomentumSystem<Dim>::apply(const Points<Dim>& u) const {
    Points<Dim> y(u.size());
    parallelFor(static_cast<int>(u.size()), [&](int i) { y[i] = inertia_[i].cwiseProduct(u[i]); });
    if (viscous_ || isConsistent()) addOfFluid(u, y);
    spreadOverBodies(y);
    if (solid_.dofs.n > 0) scatter(perBody(solid_.matrix.multiply(perBody(gather(u)))), y);
    return restricted(std::move(y));
}

template <int Dim>
Points<Dim> MomentumSystem<Dim>::precondition(const Points<Dim>& r) const {
    Points<Dim> z(r.size());
    // projected again: the round-off of a large wall reaction must not become a direction
    parallelFor(static_cast<int>(r.size()), [&](int i) {
        const Vec<Dim> diagonal = inertia_[i] + Vec<Dim>::Constant(viscousDiagonal_[i]);
        z[i].setZero();
        if (diagonal_[i] > 0) z[i] = constraints_.project(i, r[i]).cwiseQuotient(diagonal);
    });
    if (solid_.dofs.n > 0) scatter(solid_.factor->solve(gather(r)), z);
    return z;
}

/// The same with the velocities of images, which are no unknowns.
template <int Dim>
Points<Dim> MomentumSystem<Dim>::ofImages(Points<Dim> dv) const {
    step_.follow(dv);
    return dv;
}

template <int Dim>
Points<Dim> MomentumSystem<Dim>::solve(const Points<Dim>& residual) {
    Points<Dim> r(residual.size());
    parallelFor(static_cast<int>(r.size()), [&](int i) { r[i] = -residual[i]; });
    handOver<Dim>(constraints_.riders, r);
    r = restricted(std::move(r));
    iterations_ = 1;
    if (!viscous_ && !isConsistent()) return ofImages(precondition(r));  // the diagonal will do

    ofBody_.clear();
    for (const auto& body : solid_.dofs.bodies) {
        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(body.count, body.count);
        for (const int l : body.local) gram += solid_.dofs.basis[l].transpose() * solid_.dofs.basis[l];
        ofBody_.emplace_back(gram.inverse());
    }
    spreadOverBodies(r);
    auto solution = conjugateGradients<Dim>([this](const Points<Dim>& u) { return apply(u); },
                                            [this](const Points<Dim>& u) { return precondition(u); }, std::move(r),
                                            {controls_.linearTolerance, controls_.maxLinearIterations, "momentum"});
    iterations_ = solution.iterations;
    return ofImages(std::move(solution.x));
}

#define PFEM_INSTANTIATE(D) template class MomentumSystem<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
