#pragma once
// A node of the fluid that slides over a solid: it rides on a face whose nodes move.

#include "mesh/onFace.hpp"

namespace pfem {

template <int Dim>
struct Ride {
    int node;          // of the fluid
    int wall;          // the face under it, one of its supports
    Face<Dim> face;    // its nodes, of the solid
    Vec<Dim> weights;  // of these at the place of the node; their sum is 1

    /// The solid's value under the node.
    Vec<Dim> under(const Points<Dim>& value) const { return weighted<Dim>(value, face, weights); }

    /// `amount` at the node from the solid's nodes: what under() is the adjoint of.
    void spread(const Vec<Dim>& amount, Points<Dim>& value) const {
        for (int k = 0; k < Dim; ++k) value[face[k]] += weights[k] * amount;
    }
};

}  // namespace pfem
