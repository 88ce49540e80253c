// Viscous operator of the fluid's patches.

#include <gtest/gtest.h>

#include "material/herschelBulkley.hpp"
#include "material/viscosity.hpp"
#include "momentum/fluidStress.hpp"
#include "momentum/mass.hpp"
#include "momentum/residual.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double mu = 3;  // of irregularPair

struct Fluid {
    TestCase c = irregularPair();
    Topology<2> topology = c.topology();
    SmoothingDomains<2> patches = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x);
    int n = c.state.nodes.size();

    /// A yield stress of 20 Pa and a flow index of 0.6.
    void useMud() {
        for (auto& m : c.problem.materials) m.fluid.law = herschelBulkley({mu, 0.6, 20, 0.5});
    }
    Points<2> force(const PerCell<Tensor<2>>& stress) const {
        Points<2> f(n, Vec<2>::Zero());
        addInternalForce<2>(patches, stress, f);
        return f;
    }
    Points<2> viscous(const Points<2>& v, const PerPoint<double>& bulk = {}) const {
        return force(fluidTangentStress<2>(patches, {viscosities(), {}, {}}, v, bulk));
    }
    PerPoint<double> viscosities() const {
        return flowViscosity<2>(c.problem, c.state.mesh.fluid, patches, c.state.nodes.v, c.state.nodes.p).mu;
    }
    double area() const {
        double sum = 0;
        for (double volume : patches.volume) sum += volume;
        return sum;
    }
    Points<2> linear(const Tensor<2>& L) const {
        Points<2> v;
        for (const auto& x : c.state.nodes.x) v.push_back(L * x);
        return v;
    }
};

TEST(ViscousOperator, symmetricPositiveSemidefinite) {
    Fluid f;
    for (const double bulk : {0.0, 7.0}) {
        const PerPoint<double> k = bulk > 0 ? PerPoint<double>(f.n, bulk) : PerPoint<double>{};
        for (unsigned seed = 1; seed < 6; ++seed) {
            const auto u = randomVectors(f.n, seed), w = randomVectors(f.n, seed + 10);
            const double uw = dot(u, f.viscous(w, k)), wu = dot(w, f.viscous(u, k));
            EXPECT_NEAR(uw, wu, 1e-11 * std::abs(uw));
            EXPECT_GT(dot(u, f.viscous(u, k)), 1.0);
        }
    }
}

TEST(ViscousOperator, powerOfUniformRates) {
    Fluid f;
    const auto power = [&](const Tensor<2>& L) {
        const auto v = f.linear(L);
        return dot(v, f.viscous(v)) / f.area();
    };
    Tensor<2> L;
    L << 0, 2, 0, 0;  // shear
    EXPECT_NEAR(power(L), mu * 4, 1e-10);
    L << 0, -2, 2, 0;  // rotation
    EXPECT_NEAR(power(L), 0, 1e-10);
    L << 1, 0, 0, -1;  // stretching
    EXPECT_NEAR(power(L), 4 * mu, 1e-10);
    L << 1, 0, 0, 1;  // 2 mu (d - tr(d)/3 I) : d
    EXPECT_NEAR(power(L), 2 * mu * (2 - 4.0 / 3), 1e-10);
    const auto v = f.linear(L);  // plus the bulk term tr(d)^2
    EXPECT_NEAR(dot(v, f.viscous(v, PerPoint<double>(f.n, 5))) / f.area(), 4.0 * mu / 3 + 5 * 4, 1e-10);
}

TEST(ViscousOperator, isTheDerivativeOfItsResidual) {
    Fluid f;
    const auto v = randomVectors(f.n, 1), w = randomVectors(f.n, 2);
    const double eps = 1e-3;
    Points<2> plus = v, minus = v;
    for (int i = 0; i < f.n; ++i) {
        plus[i] += eps * w[i];
        minus[i] -= eps * w[i];
    }
    const auto a = viscousForce<2>(f.patches, f.viscosities(), elementGradient<2>(f.patches, plus));
    const auto b = viscousForce<2>(f.patches, f.viscosities(), elementGradient<2>(f.patches, minus));
    const auto exact = f.viscous(w);
    for (int i = 0; i < f.n; ++i) EXPECT_LT(((a[i] - b[i]) / (2 * eps) - exact[i]).norm(), 1e-9);
    EXPECT_GT(largest(exact), 1.0);
}

// Herschel-Bulkley: the matrix is the derivative of the stress, with both integrations.
TEST(ViscousOperator, ofAFluidWithYieldStressIsTheDerivative) {
    for (const Integration scheme : {Integration::nodal, Integration::elemental}) {
        Fluid f;
        f.patches.scheme = scheme;
        f.useMud();
        const auto& cells = f.c.state.mesh.fluid;
        const auto v = randomVectors(f.n, 1), w = randomVectors(f.n, 2);
        const double eps = 1e-4;
        Points<2> plus = v, minus = v;
        for (int i = 0; i < f.n; ++i) {
            plus[i] += eps * w[i];
            minus[i] -= eps * w[i];
        }
        const auto forceAt = [&](const Points<2>& u) {
            return viscousForce<2>(f.patches, flowViscosity<2>(f.c.problem, cells, f.patches, u, f.c.state.nodes.p).mu,
                                   elementGradient<2>(f.patches, u));
        };
        const auto a = forceAt(plus), b = forceAt(minus);
        const auto exact = f.force(fluidTangentStress<2>(
            f.patches, flowViscosity<2>(f.c.problem, cells, f.patches, v, f.c.state.nodes.p), w, {}));
        for (int i = 0; i < f.n; ++i) EXPECT_LT(((a[i] - b[i]) / (2 * eps) - exact[i]).norm(), 1e-5 * largest(exact));
        EXPECT_GT(largest(exact), 0.1);
    }
}

// d(g mu(g))/d g, g the shear rate
TEST(ViscousOperator, tangentViscosity) {
    Fluid f;
    f.useMud();
    const auto v = randomVectors(f.n, 3);
    const auto flow = flowViscosity<2>(f.c.problem, f.c.state.mesh.fluid, f.patches, v, f.c.state.nodes.p);
    const auto tangent = tangentViscosity<2>(flow);
    const auto L = toPoints<2>(f.patches, elementGradient<2>(f.patches, v));
    const FluidLaw& mud = *f.c.problem.fluid(0).law;
    for (int i = 0; i < f.n; ++i) {
        if (flow.mu[i] == 0) continue;  // a node of the solid
        const double g = shearRate<2>(L[i]), eps = 1e-6 * g;
        const double exact =
            ((g + eps) * mud.viscosity(g + eps, 0) - (g - eps) * mud.viscosity(g - eps, 0)) / (2 * eps);
        EXPECT_NEAR(tangent[i], exact, 1e-6 * flow.mu[i]);
        EXPECT_LT(tangent[i], flow.mu[i]);
    }
}

TEST(PressureForce, uniformPressureActsAsOutwardNormalLoad) {
    Fluid f;
    const std::vector<double> p(f.n, 2.5);
    Points<2> force(f.n, Vec<2>::Zero());
    addPressureForce<2>(f.patches, p, force);
    // the internal force is minus the push of the pressure on its boundary
    Points<2> expected(f.n, Vec<2>::Zero());
    for (const auto& face : f.topology.faces)
        for (int node : face.nodes) expected[node] -= 0.5 * 2.5 * faceArea<2>(f.c.state.nodes.x, face.nodes);
    for (int i = 0; i < f.n; ++i) EXPECT_LT((force[i] - expected[i]).norm(), 1e-13);
}

TEST(FluidMass, sumsToDensityTimesArea) {
    Fluid f;
    const auto mass = fluidMass<2>(f.c.problem, f.c.state.mesh.fluid, f.patches);
    double sum = 0;
    for (int i = 0; i < f.n; ++i) {
        EXPECT_NEAR(mass[i], 1000 * f.patches.volume[i], 1e-10);
        sum += mass[i];
    }
    EXPECT_NEAR(sum, 1000 * f.area(), 1e-9);
}

// The damping of short waves: nothing for linear velocities, it takes energy from all others, and makes no momentum.
TEST(ZigzagForce, takesEnergyFromWhatAlternates) {
    TestCase c = irregularPair();
    const auto topology = c.topology();
    const int n = c.state.nodes.size();
    for (const auto scheme : {Integration::nodal, Integration::elemental}) {
        const auto patches = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x, scheme);
        const auto force = [&](const Points<2>& v) {
            return zigzagForce<2>(c.problem, c.state.mesh.fluid, patches, 0.01, c.state.nodes.h,
                                  elementGradient<2>(patches, v));
        };
        Points<2> linear(n);
        for (int i = 0; i < n; ++i) {
            const Vec<2>& x = c.state.nodes.x[i];
            linear[i] = {1 + 2 * x[0] - x[1], 3 * x[0] + 0.5 * x[1]};
        }
        const auto v = randomVectors(n, 3), w = randomVectors(n, 4);
        EXPECT_LT(largest(force(linear)), 1e-12 * largest(force(v)));
        EXPECT_GT(dot(v, force(v)), 0);
        EXPECT_NEAR(dot(w, force(v)), dot(v, force(w)), 1e-12 * dot(v, force(v)));
        Vec<2> sum = Vec<2>::Zero();
        for (const auto& f : force(v)) sum += f;
        EXPECT_LT(sum.norm(), 1e-12 * largest(force(v)));
    }
}

}  // namespace
