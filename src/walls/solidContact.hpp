#pragma once
// Where solids are about to touch walls and each other.

#include "conditions/problem.hpp"

namespace pfem {

/// A node before a face. The relative velocity of the pair is sum weight_k v_k: 1 for the node, less the weights of the
/// face's nodes at its foot.
template <int Dim>
struct ContactPair {
    std::vector<std::pair<int, double>> weight;  // by nodes
    Tensor<Dim> frame;                           // the face's normal towards the node, then directions along the face
    double gap = 0;                              // < 0: the node has entered; solids keep 1e-3 h between them [m]

    Vec<Dim> relative(const Points<Dim>& v) const {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (const auto& [node, w] : weight) sum += w * v[node];
        return frame.transpose() * sum;
    }
};

/// Pairs that could meet within the step dt: nodes at the surface of solids before faces of walls and of solids, points
/// of walls before faces of solids. Each node has one pair at most for each smooth region of the walls and each
/// body, that of the nearest face; what has entered deeper than half of h belongs to another side. Surfaces meet only
/// when they face each other.
template <int Dim>
std::vector<ContactPair<Dim>> contactPairs(const Problem<Dim>& problem, const Mesh<Dim>& mesh,
                                           const Topology<Dim>& topology, const Nodes<Dim>& nodes, double dt);

}  // namespace pfem
