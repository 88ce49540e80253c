#include "functions/storedEnergy.hpp"

#include <algorithm>

#include "conditions/rigidBodies.hpp"
#include "functions/balance.hpp"
#include "functions/faceForce.hpp"
#include "functions/fluidMasses.hpp"
#include "material/stressTensor.hpp"
#include "momentum/fluidStress.hpp"
#include "momentum/mass.hpp"
#include "momentum/pointMotion.hpp"
#include "momentum/solidElementStress.hpp"
#include "momentum/solidHistory.hpp"
#include "momentum/wallFriction.hpp"

namespace pfem {

namespace {

template <int Dim>
double contraction(const SmoothingDomains<Dim>& domains, const PerCell<Tensor<Dim>>& stress,
                   const PerCell<Tensor<Dim>>& L) {
    double power = 0;
    for (int e = 0; e < domains.nCells(); ++e) power += domains.element[e].measure * stress[e].cwiseProduct(L[e]).sum();
    return power;
}

/// Power of walls and clamps, and what friction takes at walls. Walls: - force of the fluid on them times the velocity
/// of its nodes there, whose component along the force is the wall's; friction at a wall that slides off is
/// dissipation. Clamps: their force times their velocity.
template <int Dim>
EnergyPowers wallPower(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    EnergyPowers result;
    double& power = result.walls;
    const auto topology = makeTopology<Dim>(state.mesh, problem.conditions.kind, state.nodes.x, state.nodes.wall);
    for (const auto& face : wetFaces<Dim>(state, topology)) {
        if (face.patch < 0) continue;
        const auto force = faceForce<Dim>(problem, state, face);
        result.viscous += force.dissipation;
        if (face.solid >= 0) continue;
        for (std::size_t i = 0; i < Dim; ++i)
            power -= (force.pressure[i] + force.viscous[i]).dot(state.nodes.v[face.nodes[i]]);
        power += force.dissipation;
    }
    std::vector<int> clamped;
    for (std::size_t k = 0; k < state.mesh.patches.size(); ++k)
        if (problem.conditions.type[k]->own == Constraint::fixed)
            for (const auto& face : state.mesh.patches[k].faces)
                clamped.insert(clamped.end(), face.begin(), face.end());
    std::sort(clamped.begin(), clamped.end());
    clamped.erase(std::unique(clamped.begin(), clamped.end()), clamped.end());
    std::erase_if(clamped, [&](int i) { return state.nodes.v[i].isZero(0); });
    if (clamped.empty()) return result;
    const auto forces = supportForces<Dim>(problem, controls, state);
    for (const int i : clamped) power += forces[i].dot(state.nodes.v[i]);
    return result;
}

/// Of the force that holds a flow through periodic sides, on the cells that count.
template <int Dim>
double drivePower(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    const Vec<Dim> drive = driveOf<Dim>(problem, controls, state);
    const auto& cells = state.mesh.fluid;
    double power = 0;
    for (int e = 0; e < nOwnCells<Dim>(state); ++e) {
        const double share =
            problem.fluid(cells.material[e]).rho * simplexMeasure<Dim>(state.nodes.x, cells.nodes[e]) / (Dim + 1);
        for (const int i : cells.nodes[e]) power += share * drive.dot(state.nodes.v[i]);
    }
    return power;
}

/// sum m v of fluid, drops, solids and rigid bodies [kg/s (2D), kg m/s].
template <int Dim>
Vec<Dim> momentumOf(const Problem<Dim>& problem, const State<Dim>& state) {
    const auto& nodes = state.nodes;
    const auto fluid = withDrops<Dim>(problem, state, massOfCells<Dim>(problem, state));
    const auto solid = solidMass<Dim>(problem, state.mesh.solid, nodes.X);
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int i = 0; i < nodes.size(); ++i) sum += (fluid[i] + solid[i]) * nodes.v[i];
    for (const auto& body : rigidBodies<Dim>(problem, state.mesh, nodes))
        sum += (body.massMatrix(body.pose) * body.twist).template head<Dim>();
    return sum;
}

}  // namespace

template <int Dim>
double elasticEnergy(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    const auto& nodes = state.nodes;
    const auto& cells = state.mesh.solid;
    const auto around = nodeToCells<Dim>(cells.nodes, nodes.size());
    auto domains = makeSmoothingDomains<Dim>(cells.nodes, around, nodes.x, controls.solidScheme());
    updateGradientDomains<Dim>(problem, cells, nodes, nodes, domains);
    const auto F = toPoints<Dim>(domains, elementGradient<Dim>(domains, nodes.x));
    const auto sigma = storedAtPoints<Dim>(domains, nodes.sigma, cells.sigma);
    const History history = historyAtPoints<Dim>(problem, cells, domains, nodes.history);
    const bool whole = !controls.solid.withPressure();
    double sum = 0;
    for (int p = 0; p < nStressPoints<Dim>(domains); ++p) {
        if (!isStressPoint<Dim>(domains, p)) continue;
        const Solid& material = solidMaterial<Dim>(problem, cells, domains, p);
        const SolidLaw& law = *material.law;
        double density;
        if (law.kinematics() == Kinematics::reference) {
            std::vector<double> remembered;
            if (!history.empty())
                for (const int k : historyColumns(law, history.names)) remembered.push_back(history.at(p, k));
            density = law.shearEnergy(F[p], remembered);
            if (whole) density += law.volumeEnergy(F[p].determinant());
        } else {
            const auto [E, nu] = material.elastic;
            const Stress<Dim>& s = sigma[p];
            const double trace = s[0] + s[1] + s[2];
            double squares = 0;
            for (int c = 0; c < nStress<Dim>; ++c) squares += (c < 3 ? 1 : 2) * s[c] * s[c];
            density = 0.5 / E * ((1 + nu) * squares - nu * trace * trace);
        }
        sum += pointVolume<Dim>(domains, p) * density;
    }
    if (whole) return sum;
    const auto atNodes = withNodalPoints<Dim>(domains);
    const auto J = volumeRatio<Dim>(domains, nodes.x);
    for (int i = 0; i < nodes.size(); ++i) {
        if (!isStressPoint<Dim>(atNodes, i)) continue;
        const SolidLaw& law = *solidMaterial<Dim>(problem, cells, atNodes, i).law;
        if (law.kinematics() == Kinematics::reference) sum += domains.volume[i] * law.volumeEnergy(J[i]);
    }
    return sum;
}

template <int Dim>
StoredEnergy storedEnergy(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    StoredEnergy energy = fluidEnergy<Dim>(problem, state, controls.momentum.fluidMass());
    energy.elastic += elasticEnergy<Dim>(problem, controls, state);
    const auto& nodes = state.nodes;
    const auto mass = solidMass<Dim>(problem, state.mesh.solid, nodes.X);
    const Vec<Dim> gravity = problem.gravityOutside();
    for (int i = 0; i < nodes.size(); ++i) {
        energy.kinetic += 0.5 * mass[i] * nodes.v[i].squaredNorm();
        energy.potential -= mass[i] * gravity.dot(nodes.x[i]);
    }
    for (const auto& body : rigidBodies<Dim>(problem, state.mesh, nodes)) {
        energy.kinetic += 0.5 * body.twist.dot(body.massMatrix(body.pose) * body.twist);
        energy.potential -= body.mass * gravity.dot(body.pose.place(body.centre));
    }
    return energy;
}

template <int Dim>
EnergyPowers energyPowers(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    const auto& nodes = state.nodes;
    const auto& mesh = state.mesh;
    EnergyPowers powers;
    const auto aroundFluid = nodeToCells<Dim>(mesh.fluid.nodes, nodes.size());
    const auto fluid = makeSmoothingDomains<Dim>(mesh.fluid.nodes, aroundFluid, nodes.x, controls.fluidScheme());
    const auto mu = flowViscosity<Dim>(problem, mesh.fluid, fluid, nodes.v, nodes.p).mu;
    powers.viscous = contraction<Dim>(fluid, fluidTangentStress<Dim>(fluid, {mu, {}, {}}, nodes.v, {}),
                                      elementGradient<Dim>(fluid, nodes.v));

    // with stress zero what is left of the solid's element stress is the damper's
    const auto aroundSolid = nodeToCells<Dim>(mesh.solid.nodes, nodes.size());
    const auto solid = makeSmoothingDomains<Dim>(mesh.solid.nodes, aroundSolid, nodes.x, controls.solidScheme());
    const SolidStress<Dim> none{PerPoint<Stress<Dim>>(nStressPoints<Dim>(solid), Stress<Dim>::Zero()), {}, {}};
    powers.damper = contraction<Dim>(
        solid, solidElementStress<Dim>({problem, controls.solid, mesh.solid}, solid, solid, none, nodes),
        elementGradient<Dim>(solid, nodes.v));
    const auto walls = wallPower<Dim>(problemAt<Dim>(state.time.value, problem), controls, state);
    powers.walls = walls.walls;
    powers.viscous += walls.viscous;
    if (problem.flow) powers.drive = drivePower<Dim>(problem, controls, state);
    if (problem.frameOverTime) powers.drive -= problem.frameAcceleration.dot(momentumOf<Dim>(problem, state));
    Points<Dim> sides(nodes.size(), Vec<Dim>::Zero());
    addSideFriction<Dim>(problem, mesh.fluid, fluid, nodes.v, sides);
    addDamping<Dim>(problem, mesh.fluid, fluid, nodes, sides);
    for (int i = 0; i < nodes.size(); ++i) powers.viscous -= sides[i].dot(nodes.v[i]);
    return powers;
}

#define PFEM_INSTANTIATE(D)                                                                     \
    template double elasticEnergy<D>(const Problem<D>&, const Controls&, const State<D>&);      \
    template StoredEnergy storedEnergy<D>(const Problem<D>&, const Controls&, const State<D>&); \
    template EnergyPowers energyPowers<D>(const Problem<D>&, const Controls&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
