#pragma once
// Which simplex holds a point, and linear interpolation in it.

#include <Eigen/LU>
#include <optional>

#include "mesh/mesh.hpp"

namespace pfem {

/// A point as a weighted sum of nodes: x = sum_i weights[i] x[nodes[i]], sum of weights 1.
template <int Dim>
struct WeightedNodes {
    Simplex<Dim> nodes{};
    Eigen::Matrix<double, Dim + 1, 1> weights = Eigen::Matrix<double, Dim + 1, 1>::Zero();
    int cell = -1;
};

/// Barycentric coordinates of `point` in the simplex; not finite for a degenerate simplex.
template <int Dim>
Eigen::Matrix<double, Dim + 1, 1> barycentric(const Simplex<Dim>& simplex, const Points<Dim>& x,
                                              const Vec<Dim>& point) {
    Tensor<Dim> edges;
    for (int i = 0; i < Dim; ++i) edges.col(i) = x[simplex[i + 1]] - x[simplex[0]];
    Eigen::Matrix<double, Dim + 1, 1> weights;
    weights.template tail<Dim>() = edges.inverse() * (point - x[simplex[0]]);
    weights[0] = 1.0 - weights.template tail<Dim>().sum();
    return weights;
}

/// The cell in which `point` lies deepest; nothing when every cell has a barycentric coordinate below
/// -tolerance. Of equal cells (a point on a common face) the first. Cost: one pass over the cells.
template <int Dim>
std::optional<WeightedNodes<Dim>> locate(const Cells<Dim>& cells, const Points<Dim>& x, const Vec<Dim>& point,
                                         double tolerance = 1e-6) {
    std::optional<WeightedNodes<Dim>> best;
    double deepest = -tolerance;
    for (int e = 0; e < cells.size(); ++e) {
        const Simplex<Dim>& simplex = cells.nodes[static_cast<std::size_t>(e)];
        Vec<Dim> low = x[simplex[0]], high = low;
        for (int i = 1; i <= Dim; ++i) {
            low = low.cwiseMin(x[simplex[i]]);
            high = high.cwiseMax(x[simplex[i]]);
        }
        const double margin = tolerance * (high - low).maxCoeff();
        if (((point - low).array() < -margin).any() || ((point - high).array() > margin).any()) continue;
        const auto weights = barycentric<Dim>(simplex, x, point);
        const double depth = weights.minCoeff();
        if (!weights.allFinite() || depth < -tolerance || (best && depth <= deepest)) continue;
        deepest = depth;
        best = WeightedNodes<Dim>{simplex, weights, e};
    }
    return best;
}

/// sum_i weights[i] values[nodes[i]]
template <int Dim, class Value>
Value interpolate(const WeightedNodes<Dim>& at, const std::vector<Value>& values) {
    Value sum = at.weights[0] * values[at.nodes[0]];
    for (int i = 1; i <= Dim; ++i) sum += at.weights[i] * values[at.nodes[i]];
    return sum;
}

}  // namespace pfem
