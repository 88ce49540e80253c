#include "momentum/contactForces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pfem {

namespace {

/// Does a force along the normal move the pair with this response? Not where both sides are held, nor straight under a
/// hinge, where what comes out is round-off.
template <int Dim>
bool givesWay(const Tensor<Dim>& own) {
    return own(0, 0) > 1e-10 * own.trace();
}

}  // namespace

template <int Dim>
ContactForces<Dim>::ContactForces(std::vector<ContactPair<Dim>> pairs, double dt, double friction)
    : pairs_(std::move(pairs)),
      dt_(dt),
      friction_(friction),
      bound_(pairs_.size()),
      force_(pairs_.size(), Vec<Dim>::Zero()) {}

/// W and A^-1 J^T with the present levers of rigid bodies.
template <int Dim>
void ContactForces<Dim>::respond(const MomentumSystem<Dim>& system) {
    const auto n = static_cast<Eigen::Index>(pairs_.size() * Dim);
    Eigen::MatrixXd rows(system.solid().dofs.n, n);
    answer_.resize(system.solid().dofs.n, n);
    for (Eigen::Index c = 0; c < n; ++c) {
        std::vector<std::pair<int, Vec<Dim>>> forces;
        const auto& pair = pairs_[static_cast<std::size_t>(c / Dim)];
        for (const auto& [node, w] : pair.weight) forces.emplace_back(node, w * pair.frame.col(c % Dim));
        rows.col(c) = system.onSolids(forces);
        answer_.col(c) = system.solveSolids(rows.col(c));
    }
    W_ = rows.transpose() * answer_;
}

/// Sweeps over the pairs until nothing changes.
template <int Dim>
void ContactForces<Dim>::relax(std::vector<Vec<Dim>>& u) {
    constexpr int maxSweeps = 2000;
    double largest = 0;
    for (const auto& one : u) largest = std::max(largest, one.norm());
    const int n = static_cast<int>(pairs_.size());
    for (int sweep = 0; sweep < maxSweeps; ++sweep) {
        double change = 0;
        for (int c = 0; c < n; ++c) {
            const Tensor<Dim> own = W_.block<Dim, Dim>(c * Dim, c * Dim);
            if (!givesWay<Dim>(own)) continue;
            Vec<Dim> next = force_[c];
            next[0] = std::max(0.0, next[0] - (u[c][0] - bound_[c]) / own(0, 0));
            auto along = next.template tail<Dim - 1>();
            if (friction_ > 0) {
                const double stiffest = own.template bottomRightCorner<Dim - 1, Dim - 1>().trace();
                along -= (u[c] + own.col(0) * (next[0] - force_[c][0])).template tail<Dim - 1>() / stiffest;
                const double most = friction_ * next[0], size = along.norm();
                if (size > most) along *= most / size;
            }
            const Vec<Dim> step = next - force_[c];
            if (step.isZero(0)) continue;
            force_[c] = next;
            for (int d = 0; d < n; ++d) u[d] += W_.block<Dim, Dim>(d * Dim, c * Dim) * step;
            change = std::max(change, (own * step).norm());
        }
        if (change <= 1e-11 * largest) return;
    }
}

/// L such that the velocities u_free + W L obey their bounds.
template <int Dim>
void ContactForces<Dim>::answer(std::vector<Vec<Dim>> u) {
    const Eigen::VectorXd made = W_ * forces();  // by the forces of the last iterate
    for (std::size_t c = 0; c < pairs_.size(); ++c) u[c] += made.segment<Dim>(static_cast<Eigen::Index>(c * Dim));
    relax(u);
}

template <int Dim>
Eigen::VectorXd ContactForces<Dim>::forces() const {
    const auto n = static_cast<Eigen::Index>(pairs_.size());
    Eigen::VectorXd all(n * Dim);
    for (Eigen::Index c = 0; c < n; ++c) all.segment<Dim>(c * Dim) = force_[static_cast<std::size_t>(c)];
    return all;
}

/// Of a pair whose sides are both held, by motions or at rest, neither gives way.
template <int Dim>
void ContactForces<Dim>::demandWay(const Nodes<Dim>& end) const {
    for (std::size_t c = 0; c < pairs_.size(); ++c) {
        const auto own = static_cast<Eigen::Index>(c * Dim);
        if (givesWay<Dim>(W_.block<Dim, Dim>(own, own))) continue;
        const int i = pairs_[c].weight[0].first;
        const double gap = pairs_[c].gapAt(end.x), h = end.h[i];
        if (gap > -0.01 * h || gap > pairs_[c].gap - 1e-6 * h) continue;
        throw StepFailure(
            fmt::format("node {} at ({:.6g}) is driven into what it meets, a wall or a solid: the patches that hold "
                        "them move them together, and neither can give way. End the motion before they meet",
                        end.id[i], fmt::join(end.x[i].data(), end.x[i].data() + Dim, " ")),
            {end.id[i]});
    }
}

template <int Dim>
void ContactForces<Dim>::add(const MomentumSystem<Dim>& system, const Nodes<Dim>& end, Points<Dim>& dv) {
    if (!any()) return;
    if (W_.size() == 0 || !system.solid().dofs.bodies.empty()) respond(system);
    std::vector<Vec<Dim>> u;
    for (std::size_t c = 0; c < pairs_.size(); ++c) {
        const ContactPair<Dim>& pair = pairs_[c];
        const double slowly = 0.9 * std::min(0.0, pair.gap);  // what has entered comes out by a tenth
        u.push_back(pair.relative(end.v));
        u[c][0] = pair.rateAt(end.x, end.v);
        bound_[c] = 0.5 * u[c][0] - (pair.gapAt(end.x) - slowly) / dt_;
        u[c] += pair.relative(dv);
    }
    demandWay(end);
    answer(std::move(u));
    system.addOfSolids(answer_ * forces(), dv);
}

template <int Dim>
bool ContactForces<Dim>::strikes(const Points<Dim>& v) const {
    double fastest = 0;
    for (const auto& pair : pairs_)
        for (const auto& [node, w] : pair.weight) fastest = std::max(fastest, v[node].norm());
    return std::any_of(pairs_.begin(), pairs_.end(),
                       [&](const auto& pair) { return pair.relative(v)[0] < slowest(pair) - 1e-10 * fastest; });
}

template <int Dim>
void ContactForces<Dim>::stop(const MomentumSystem<Dim>& system, Points<Dim>& v) {
    respond(system);
    std::vector<Vec<Dim>> u;
    for (const auto& pair : pairs_) u.push_back(pair.relative(v));
    for (std::size_t c = 0; c < pairs_.size(); ++c) bound_[c] = slowest(pairs_[c]);
    answer(std::move(u));
    system.addOfSolids(answer_ * forces(), v);
}

#define PFEM_INSTANTIATE(D) template class ContactForces<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
