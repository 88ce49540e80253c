#pragma once
// The force of the fluid on one face of a wall or a solid.

#include "conditions/problem.hpp"
#include "functions/wetFaces.hpp"

namespace pfem {

/// Shares of the face's nodes [N/m (2D), N].
template <int Dim>
struct FaceForce {
    std::array<Vec<Dim>, Dim> pressure, viscous;
    double dissipation = 0;  // by friction at the wall [W/m (2D), W]
};

/// int N_i (p n - s n) dA with n out of the fluid: exact for the linear p of the face; s = 2 mu (d - tr(d)/3
/// I) of the face's cell, on slip walls its normal part only and the wall's friction. problem: of the state's time.
template <int Dim>
FaceForce<Dim> faceForce(const Problem<Dim>& problem, const State<Dim>& state, const WetFace<Dim>& face);

}  // namespace pfem
