#include "solver/inelastic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/leastSquares.hpp"
#include "base/spectrum.hpp"

namespace pfem {

namespace {

template <int Dim>
using CellVelocities = std::array<Vec<Dim>, Dim + 1>;

/// The part that the node may not choose.
template <int Dim>
Tensor<Dim> heldPart(const MeetingCell<Dim>& cell, int k) {
    return Tensor<Dim>::Identity() - cell.freedom[k];
}

template <int Dim>
using NodalVector = Eigen::Matrix<double, Dim*(Dim + 1), 1>;

/// Velocities at the nodes by translations, one a column, then turns about `centre`.
template <int Dim>
Eigen::Matrix<double, Dim*(Dim + 1), Eigen::Dynamic> rigidModes(const MeetingCell<Dim>& cell, const Vec<Dim>& centre) {
    Eigen::Matrix<double, Dim*(Dim + 1), Eigen::Dynamic> modes(Dim * (Dim + 1), Dim + Dim * (Dim - 1) / 2);
    modes.setZero();
    double size = 0;
    for (const auto& x : cell.x) size = std::max(size, (x - centre).norm());
    for (int k = 0; k <= Dim; ++k) {
        modes.template block<Dim, Dim>(Dim * k, 0).setIdentity();
        const Vec<Dim> r = (cell.x[k] - centre) / size;
        for (int a = 0, mode = Dim; a < Dim; ++a)
            for (int b = a + 1; b < Dim; ++b, ++mode) {
                modes(Dim * k + a, mode) = -r[b];
                modes(Dim * k + b, mode) = r[a];
            }
    }
    return modes;
}

/// Velocities at all nodes of the rigid motion that the holds have in common, without a turn where they need
/// none; nothing where they move to each other.
template <int Dim>
std::optional<CellVelocities<Dim>> frameOf(const MeetingCell<Dim>& cell) {
    CellVelocities<Dim> frame;
    frame.fill(Vec<Dim>::Zero());
    NodalVector<Dim> held;
    Vec<Dim> centre = Vec<Dim>::Zero();
    double weight = 0;
    for (int k = 0; k <= Dim; ++k) {
        held.template segment<Dim>(Dim * k) = heldPart<Dim>(cell, k) * cell.v[k];
        centre += heldPart<Dim>(cell, k).trace() * cell.x[k];
        weight += heldPart<Dim>(cell, k).trace();
    }
    if (held.isZero(0)) return frame;  // nothing moves that holds
    const auto modes = rigidModes<Dim>(cell, centre / weight);
    auto ofHolds = modes;
    for (int k = 0; k <= Dim; ++k)
        ofHolds.template middleRows<Dim>(Dim * k) = heldPart<Dim>(cell, k) * modes.template middleRows<Dim>(Dim * k);
    for (const Eigen::Index nModes : {Eigen::Index(Dim), modes.cols()}) {
        const Eigen::VectorXd motion = leastSquares(ofHolds.leftCols(nModes), held);
        if ((ofHolds.leftCols(nModes) * motion - held).norm() > 1e-9 * held.norm()) continue;
        const NodalVector<Dim> all = modes.leftCols(nModes) * motion;
        for (int k = 0; k <= Dim; ++k) frame[k] = all.template segment<Dim>(Dim * k);
        return frame;
    }
    return {};
}

/// Projector on the directions in which all nodes are free.
template <int Dim>
Tensor<Dim> commonFreedom(const MeetingCell<Dim>& cell) {
    Tensor<Dim> held = Tensor<Dim>::Zero();
    for (int k = 0; k <= Dim; ++k) held += heldPart<Dim>(cell, k);
    const auto eigen = spectrum<Dim>(held);
    Tensor<Dim> common = Tensor<Dim>::Zero();
    for (int d = 0; d < Dim; ++d)
        if (eigen.values[d] < 1e-12) common += eigen.vectors.col(d) * eigen.vectors.col(d).transpose();
    return common;
}

/// The least beta in [0, 1] with |a + beta (w - a)| <= limit, which |w| does not exceed.
template <int Dim>
double wayTo(const Vec<Dim>& w, const Vec<Dim>& a, double limit) {
    const double excess = a.squaredNorm() - limit * limit;
    if (!(excess > 0)) return 0;
    const double across = a.dot(w - a);  // < 0
    const double root = across * across - (w - a).squaredNorm() * excess;
    return std::min(1.0, excess / (-across + std::sqrt(std::max(0.0, root))));
}

template <int Dim>
double largestNorm(const CellVelocities<Dim>& u, const Vec<Dim>& from) {
    double largest = 0;
    for (const auto& one : u) largest = std::max(largest, (one - from).norm());
    return largest;
}

}  // namespace

template <int Dim>
double MeetingCell<Dim>::divergence() const {
    double div = 0;
    for (int k = 0; k <= Dim; ++k) div += v[k].dot(gradN[k]);
    return div;
}

template <int Dim>
bool stopClosing(MeetingCell<Dim>& cell) {
    const double div = cell.divergence();
    CellVelocities<Dim> change;  // by an impulse of 1
    double mobility = 0;
    for (int k = 0; k <= Dim; ++k) {
        if (!(cell.mass[k] > 0)) return false;
        change[k] = cell.freedom[k] * cell.gradN[k] / cell.mass[k];
        mobility += change[k].dot(cell.gradN[k]);
    }
    if (!(div < 0 && mobility > 0)) return false;
    const auto frame = frameOf<Dim>(cell);
    if (!frame) return false;

    CellVelocities<Dim> before, after;
    Vec<Dim> together = Vec<Dim>::Zero();
    double mass = 0;
    for (int k = 0; k <= Dim; ++k) {
        before[k] = cell.v[k] - (*frame)[k];
        after[k] = before[k] - div / mobility * change[k];
        together += cell.mass[k] * before[k];
        mass += cell.mass[k];
    }
    together = commonFreedom<Dim>(cell) * together / mass;
    const double apart = std::max(cell.apart, largestNorm<Dim>(before, together)),
                 apartAfter = largestNorm<Dim>(after, together);
    double beta = apartAfter > apart ? 1 - apart / apartAfter : 0;
    const double limit = std::max(cell.speed, largestNorm<Dim>(before, Vec<Dim>::Zero()));
    for (const auto& u : after) beta = std::max(beta, wayTo<Dim>(together, u, limit));
    for (int k = 0; k <= Dim; ++k) cell.v[k] += cell.freedom[k] * (after[k] + beta * (together - after[k]) - before[k]);
    return true;
}

template struct MeetingCell<2>;
template struct MeetingCell<3>;
template bool stopClosing<2>(MeetingCell<2>&);
template bool stopClosing<3>(MeetingCell<3>&);

}  // namespace pfem
