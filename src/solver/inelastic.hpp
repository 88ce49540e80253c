#pragma once
// One cell that closes is stopped by an impulse, and nobody becomes faster.

#include <array>

#include "base/types.hpp"

namespace pfem {

/// The nodes of a cell in which two surfaces meet, as the impulse sees them.
template <int Dim>
struct MeetingCell {
    std::array<Vec<Dim>, Dim + 1> x;           // positions [m]
    std::array<Vec<Dim>, Dim + 1> v;           // velocities, what is held with that of its wall [m/s]
    std::array<Vec<Dim>, Dim + 1> gradN;       // [1/m]
    std::array<double, Dim + 1> mass;          // [kg/m (2D), kg]
    std::array<Tensor<Dim>, Dim + 1> freedom;  // projector on what the node may do: identity, along a wall, zero

    /// What every node may have in any case, seen from the frame and from w (below) [m/s]: of others that
    /// meet at the same time.
    double speed = 0, apart = 0;

    double divergence() const;  // < 0: closes [1/s]
};

/// Make div v = 0 in a cell that closes. Seen from what holds its nodes (a rigid motion; without any: from
/// where we are), u = v - frame, with the projectors P_I of the holds,
///   u*_I = u_I + lambda P_I grad N_I / m_I,      lambda = -div / sum_I grad N_I . P_I grad N_I / m_I,
/// is the inelastic impact: of all motions with div v = 0 that impulses on the free parts can reach, the
/// nearest in the sense of kinetic energy. It can throw a light node: one at the end of a long lever, or one
/// that is squeezed out. Then part of the way is that to
///   w = sum_I m_I T u_I / sum_I m_I,      T: what all nodes may do together,
/// in which they stick to each other:  u_I <- (1 - beta) u*_I + beta w  with the least beta such that for all
/// nodes
///   |u_I| <= max_J |u_J| before, or `speed`,      |u_I - w| <= max_J |u_J - w| before, or `apart`.
/// beta = 1 does so: it always exists, and is mostly 0. Both ends have div = 0, the same momentum along T,
/// and not more kinetic energy than before; so has all between them. The moment of momentum stays where beta
/// = 0 and nothing is held. What is held keeps its velocity. False, and nothing is changed: the cell does not
/// close, no node that is free can stop it, or its holds move towards each other.
template <int Dim>
bool stopClosing(MeetingCell<Dim>& cell);

}  // namespace pfem
