#pragma once
// Where solids are about to touch walls and each other.

#include "conditions/problem.hpp"
#include "mesh/onFace.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

/// A node before a face. The relative velocity of the pair is sum weight_k v_k: 1 for the node, the first, less the
/// weights of the face's nodes at its foot, in their order.
template <int Dim>
struct ContactPair {
    std::vector<std::pair<int, double>> weight;  // by nodes
    Tensor<Dim> frame;                           // the face's normal towards the node, then directions along the face
    double gap = 0;                              // < 0: the node has entered [m]
    double kept = 0;                             // of the distance, what the gap leaves out: solids keep 1e-3 h [m]

    Vec<Dim> relative(const Points<Dim>& v) const {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (const auto& [node, w] : weight) sum += w * v[node];
        return frame.transpose() * sum;
    }
    /// The gap in other positions, also of a face that has turned, and how fast it grows there.
    double gapAt(const Points<Dim>& x) const { return normalAt(x).dot(x[weight[0].first] - x[weight[1].first]) - kept; }
    double rateAt(const Points<Dim>& x, const Points<Dim>& v) const {
        const Vec<Dim> foot = footWeights<Dim>(x, face(), x[weight[0].first]);
        return normalAt(x).dot(v[weight[0].first] - weighted<Dim>(v, face(), foot));
    }

private:
    Face<Dim> face() const {
        Face<Dim> nodes{};
        for (int k = 0; k < Dim; ++k) nodes[k] = weight[k + 1].first;
        return nodes;
    }
    Vec<Dim> normalAt(const Points<Dim>& x) const {
        const Vec<Dim> normal = faceArea<Dim>(x, face()).normalized();
        return normal.dot(frame.col(0)) < 0 ? Vec<Dim>(-normal) : normal;
    }
};

/// Pairs that could meet within the step dt: nodes at the surface of solids before faces of walls and of solids, points
/// of walls before faces of solids. Of the faces of a smooth region of the walls, or of a body, that look the same way
/// a node has a pair with the nearest alone; what has entered deeper than half of h belongs to another side. A node
/// meets a face only where its own surface goes away from it on all sides.
template <int Dim>
std::vector<ContactPair<Dim>> contactPairs(const Problem<Dim>& problem, const Mesh<Dim>& mesh,
                                           const Topology<Dim>& topology, const Nodes<Dim>& nodes, double dt);

}  // namespace pfem
