#pragma once
// The step as a linear map near rest: its amplification matrix by differences of the real step.

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "support/cases.hpp"

namespace pfem::test {

/// The quantities of a state that a step takes from it, but for those without memory (accelerations), as one vector
/// without units, and back.
class StateVector {
    enum Kind { position, velocity, pressure, lostVolume, stress };
    struct Entry {
        int node;
        Kind kind;
        Vec<2> direction;  // of vectors; of a stress its component
        double scale;
    };
    static double value(const Nodes<2>& n, const Entry& e) {
        switch (e.kind) {
            case position:
                return n.x[e.node].dot(e.direction);
            case velocity:
                return n.v[e.node].dot(e.direction);
            case pressure:
                return n.p[e.node];
            case lostVolume:
                return n.lostVolume[e.node];
            default:
                return n.sigma[e.node][static_cast<int>(e.direction[0])];
        }
    }
    static void change(Nodes<2>& n, const Entry& e, double amount) {
        switch (e.kind) {
            case position:
                n.x[e.node] += amount * e.direction;
                break;
            case velocity:
                n.v[e.node] += amount * e.direction;
                break;
            case pressure:
                n.p[e.node] += amount;
                break;
            case lostVolume:
                n.lostVolume[e.node] += amount;
                break;
            default:
                n.sigma[e.node][static_cast<int>(e.direction[0])] += amount;
        }
    }
    static std::vector<Vec<2>> freeDirections(const NodeConstraints<2>& constraints, int i) {
        const Freedom<2>& freedom = constraints.freedom[i];
        std::vector<Vec<2>> directions;
        for (int c = 0; c < freedom.count; ++c) directions.emplace_back(freedom.basis.col(c));
        return directions;
    }

public:
    /// For steps of length dt: no unit moves a node by more than some h within one.
    StateVector(const TestCase& rest, double dt) : rest_(rest.state.nodes) {
        const auto topology = rest.topology();
        const auto constraints = rest.constraints(topology);
        const double g = rest.problem.gravity.norm();
        const double h = rest_.h[0], speed = std::min(std::sqrt(g * h), h / dt), pressed = 1000 * speed * speed;
        for (int i = 0; i < rest_.size(); ++i) {
            if (!topology.wet(i) && !topology.onSolid[i]) continue;
            for (const Vec<2>& e : freeDirections(constraints, i)) {
                add(i, position, e, h);
                add(i, velocity, e, speed);
            }
            if (topology.wet(i)) {
                add(i, pressure, Vec<2>::Zero(), pressed);
                add(i, lostVolume, Vec<2>::Zero(), h * h);
            }
            if (topology.onSolid[i])
                for (int c = 0; c < Stress<2>::RowsAtCompileTime; ++c) add(i, stress, Vec<2>(c, 0), pressed);
        }
    }

    int size() const { return static_cast<int>(entry_.size()); }

    /// (nodes - rest) / scale.
    Eigen::VectorXd of(const Nodes<2>& nodes) const {
        Eigen::VectorXd y(size());
        for (int k = 0; k < size(); ++k) y[k] = (value(nodes, entry_[k]) - value(rest_, entry_[k])) / entry_[k].scale;
        return y;
    }
    Nodes<2> nodes(const Eigen::VectorXd& y) const {
        Nodes<2> n = rest_;
        for (int k = 0; k < size(); ++k) change(n, entry_[k], y[k] * entry_[k].scale);
        return n;
    }

    /// Displacements that leave the fluid at rest: of inner nodes, with their pressure; along the surface and walls; of
    /// a solid that floats, along the surface. (Rectangular tanks; solids all float or none.)
    Eigen::MatrixXd equilibria(const TestCase& rest) const {
        const auto topology = rest.topology();
        std::vector<Eigen::VectorXd> found;
        for (int k = 0; k < size(); ++k) {
            const Entry& e = entry_[k];
            if (e.kind != position || topology.onSolid[e.node]) continue;
            if (topology.freeSurface[e.node] && std::abs(e.direction[1]) > 1e-9) continue;
            Nodes<2> n = rest_;
            const Vec<2> dx = e.scale * e.direction;
            n.x[e.node] += dx;
            n.p[e.node] += 1000 * rest.problem.gravity.dot(dx);
            found.push_back(of(n));
        }
        const auto constraints = rest.constraints(topology);
        Nodes<2> shifted = rest_;
        bool solids = false, held = false;
        for (int i = 0; i < rest_.size(); ++i) {
            if (!topology.onSolid[i]) continue;
            solids = true;
            held |= !constraints.freedom[i].all();
            shifted.x[i][0] += rest_.h[i];
        }
        if (solids && !held) found.push_back(of(shifted));
        Eigen::MatrixXd B(size(), static_cast<int>(found.size()));
        for (std::size_t j = 0; j < found.size(); ++j) B.col(static_cast<int>(j)) = found[j];
        return B;
    }

private:
    void add(int node, Kind kind, const Vec<2>& direction, double scale) {
        entry_.push_back({node, kind, direction, scale});
    }

    Nodes<2> rest_;
    std::vector<Entry> entry_;
};

/// Derivative of one whole step (motion, surface, walls, connectivity) by the state at rest, by differences of fourth
/// order.
inline Eigen::MatrixXd amplification(const TestCase& rest, const StateVector& vector, double dt, double eps = 1e-3) {
    const int n = vector.size();
    Eigen::MatrixXd G(n, n);
    const auto stepped = [&](int k, double amount) {
        TestCase c = rest;
        Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
        y[k] = amount;
        c.state.nodes = vector.nodes(y);
        const auto report = c.step(dt);
        if (report.rejected > 0) throw std::runtime_error("rejected: " + report.reasons.front());
        return vector.of(c.state.nodes);
    };
    for (int k = 0; k < n; ++k)
        G.col(k) =
            (8 * (stepped(k, eps) - stepped(k, -eps)) - (stepped(k, 2 * eps) - stepped(k, -2 * eps))) / (12 * eps);
    return G;
}

/// The eigenvalues of G without those of the known equilibria B (G B = B).
inline Eigen::VectorXcd eigenvaluesBeside(const Eigen::MatrixXd& G, const Eigen::MatrixXd& B) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(B);
    const Eigen::MatrixXd Q = Eigen::MatrixXd(qr.householderQ()).rightCols(G.rows() - B.cols());
    return Eigen::MatrixXd(Q.transpose() * G * Q).eigenvalues();
}

}  // namespace pfem::test
