#include "functions/faceForce.hpp"

#include "material/viscosity.hpp"
#include "mesh/simplex.hpp"
#include "momentum/wallFriction.hpp"

namespace pfem {

namespace {

/// s = 2 mu (d - tr(d)/3 I) of a fluid cell.
template <int Dim>
Tensor<Dim> viscousStressOfCell(const Problem<Dim>& problem, const State<Dim>& state, int cell) {
    const auto& simplex = state.mesh.fluid.nodes[cell];
    const auto geometry = simplexGeometry<Dim>(state.nodes.x, simplex);
    Tensor<Dim> L = Tensor<Dim>::Zero();
    for (int k = 0; k <= Dim; ++k) L += state.nodes.v[simplex[k]] * geometry.gradN[k].transpose();
    const auto& fluid = problem.fluid(state.mesh.fluid.material[cell]);
    double p = 0;
    for (const int node : simplex) p += state.nodes.p[node] / (Dim + 1);
    return viscousStress<Dim>(fluid.law->viscosity(shearRate<Dim>(L), p), L);
}

/// int N_i N_j dA / |face|
template <int Dim>
double shape(int i, int j) {
    return (i == j ? 2.0 : 1.0) / (Dim * (Dim + 1));
}

}  // namespace

template <int Dim>
FaceForce<Dim> faceForce(const Problem<Dim>& problem, const State<Dim>& state, const WetFace<Dim>& face) {
    const Vec<Dim> area = faceArea<Dim>(state.nodes.x, face.nodes);
    Vec<Dim> traction = -(viscousStressOfCell<Dim>(problem, state, face.cell) * area);
    if (face.patch >= 0 && problem.conditions.type[face.patch]->wet == Constraint::slide)
        traction = area * (area.dot(traction) / area.squaredNorm());
    const bool slips = face.patch >= 0 && problem.conditions.friction[face.patch] > 0;
    const double rho = problem.fluid(state.mesh.fluid.material[face.cell]).rho;
    FaceForce<Dim> force;
    for (int i = 0; i < Dim; ++i) {
        double p = 0;
        for (int j = 0; j < Dim; ++j) p += shape<Dim>(i, j) * state.nodes.p[face.nodes[j]];
        force.pressure[i] = p * area;
        force.viscous[i] = traction / Dim;
        if (!slips) continue;
        const int node = face.nodes[i];
        const Vec<Dim> u = slidingVelocity<Dim>(problem, face.patch, area.normalized(), state.nodes.x[node],
                                                state.nodes.v[node] - face.under[static_cast<std::size_t>(i)]);
        const Vec<Dim> friction = area.norm() / Dim * wallFriction<Dim>(problem, face.patch, rho, u);
        force.viscous[i] -= friction;
        force.dissipation -= friction.dot(u);
    }
    return force;
}

#define PFEM_INSTANTIATE(D) template FaceForce<D> faceForce<D>(const Problem<D>&, const State<D>&, const WetFace<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
