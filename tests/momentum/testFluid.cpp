// Viscous operator of the fluid's patches.

#include <gtest/gtest.h>

#include "material/herschelBulkley.hpp"
#include "material/viscosity.hpp"
#include "momentum/fluidStress.hpp"
#include "momentum/mass.hpp"
#include "momentum/residual.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double mu = 3;  // of irregular()

PFEM_BOTH_DIMENSIONS(ViscousOperator);
PFEM_BOTH_DIMENSIONS(PressureForce);
PFEM_BOTH_DIMENSIONS(FluidMass);
PFEM_BOTH_DIMENSIONS(ZigzagForce);

template <int Dim>
struct Fluid {
    CaseOf<Dim> c = irregular<Dim>();
    Topology<Dim> topology = c.topology();
    SmoothingDomains<Dim> patches =
        makeSmoothingDomains<Dim>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x);
    int n = c.state.nodes.size();

    /// A yield stress of 20 Pa and a flow index of 0.6.
    void useMud() {
        for (auto& m : c.problem.materials) m.fluid.law = herschelBulkley({mu, 0.6, 20, 0.5});
    }
    Points<Dim> force(const PerCell<Tensor<Dim>>& stress) const {
        Points<Dim> f(n, Vec<Dim>::Zero());
        addInternalForce<Dim>(patches, stress, f);
        return f;
    }
    Points<Dim> viscous(const Points<Dim>& v, const PerPoint<double>& bulk = {}) const {
        return force(fluidTangentStress<Dim>(patches, {viscosities(), {}, {}}, v, bulk));
    }
    PerPoint<double> viscosities() const {
        return flowViscosity<Dim>(c.problem, c.state.mesh.fluid, patches, c.state.nodes.v, c.state.nodes.p).mu;
    }
    double area() const {
        double sum = 0;
        for (double volume : patches.volume) sum += volume;
        return sum;
    }
    Points<Dim> linear(const Tensor<Dim>& L) const {
        Points<Dim> v;
        for (const auto& x : c.state.nodes.x) v.push_back(L * x);
        return v;
    }
};

TYPED_TEST(ViscousOperator, symmetricPositiveSemidefinite) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f;
    for (const double bulk : {0.0, 7.0}) {
        const PerPoint<double> k = bulk > 0 ? PerPoint<double>(f.n, bulk) : PerPoint<double>{};
        for (unsigned seed = 1; seed < 6; ++seed) {
            const auto u = someVectors<Dim>(f.n, seed), w = someVectors<Dim>(f.n, seed + 10);
            const double uw = dot(u, f.viscous(w, k)), wu = dot(w, f.viscous(u, k));
            EXPECT_NEAR(uw, wu, 1e-11 * std::abs(uw));
            EXPECT_GT(dot(u, f.viscous(u, k)), 1.0);
        }
    }
}

TYPED_TEST(ViscousOperator, powerOfUniformRates) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f;
    const auto power = [&](const Tensor<Dim>& L) {
        const auto v = f.linear(L);
        return dot(v, f.viscous(v)) / f.area();
    };
    Tensor<Dim> L = corner<Dim>({0, 2, 0, 0, 0, 0, 0, 0, 0});  // shear
    EXPECT_NEAR(power(L), mu * 4, 1e-10);
    L = corner<Dim>({0, -2, 1, 2, 0, 3, -1, -3, 0});  // rotation
    EXPECT_NEAR(power(L), 0, 1e-10);
    L = corner<Dim>({1, 0, 0, 0, -1, 0, 0, 0, 0});  // stretching
    EXPECT_NEAR(power(L), 4 * mu, 1e-10);
    L = Tensor<Dim>::Identity();  // 2 mu (d - tr(d)/3 I) : d
    EXPECT_NEAR(power(L), 2 * mu * (Dim - Dim * Dim / 3.0), 1e-10);
    const auto v = f.linear(L);  // plus the bulk term tr(d)^2
    EXPECT_NEAR(dot(v, f.viscous(v, PerPoint<double>(f.n, 5))) / f.area(),
                2 * mu * (Dim - Dim * Dim / 3.0) + 5 * Dim * Dim, 1e-10);
}

TYPED_TEST(ViscousOperator, isTheDerivativeOfItsResidual) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f;
    const auto v = someVectors<Dim>(f.n, 1), w = someVectors<Dim>(f.n, 2);
    const double eps = 1e-3;
    Points<Dim> plus = v, minus = v;
    for (int i = 0; i < f.n; ++i) {
        plus[i] += eps * w[i];
        minus[i] -= eps * w[i];
    }
    const auto a = viscousForce<Dim>(f.patches, f.viscosities(), velocityGradients<Dim>(f.patches, plus));
    const auto b = viscousForce<Dim>(f.patches, f.viscosities(), velocityGradients<Dim>(f.patches, minus));
    const auto exact = f.viscous(w);
    for (int i = 0; i < f.n; ++i) EXPECT_LT(((a[i] - b[i]) / (2 * eps) - exact[i]).norm(), 1e-9);
    EXPECT_GT(largest(exact), 1.0);
}

// Herschel-Bulkley: the matrix is the derivative of the stress, with both integrations.
TYPED_TEST(ViscousOperator, ofAFluidWithYieldStressIsTheDerivative) {
    constexpr int Dim = TypeParam::value;
    for (const Integration scheme : {Integration::nodal, Integration::elemental}) {
        Fluid<Dim> f;
        f.patches.scheme = scheme;
        f.useMud();
        const auto& cells = f.c.state.mesh.fluid;
        const auto v = someVectors<Dim>(f.n, 1), w = someVectors<Dim>(f.n, 2);
        const double eps = 1e-4;
        Points<Dim> plus = v, minus = v;
        for (int i = 0; i < f.n; ++i) {
            plus[i] += eps * w[i];
            minus[i] -= eps * w[i];
        }
        const auto forceAt = [&](const Points<Dim>& u) {
            return viscousForce<Dim>(f.patches,
                                     flowViscosity<Dim>(f.c.problem, cells, f.patches, u, f.c.state.nodes.p).mu,
                                     velocityGradients<Dim>(f.patches, u));
        };
        const auto a = forceAt(plus), b = forceAt(minus);
        const auto exact = f.force(fluidTangentStress<Dim>(
            f.patches, flowViscosity<Dim>(f.c.problem, cells, f.patches, v, f.c.state.nodes.p), w, {}));
        for (int i = 0; i < f.n; ++i) EXPECT_LT(((a[i] - b[i]) / (2 * eps) - exact[i]).norm(), 1e-5 * largest(exact));
        EXPECT_GT(largest(exact), 0.1);
    }
}

// d(g mu(g))/d g, g the shear rate
TYPED_TEST(ViscousOperator, tangentViscosity) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f;
    f.useMud();
    const auto v = someVectors<Dim>(f.n, 3);
    const auto flow = flowViscosity<Dim>(f.c.problem, f.c.state.mesh.fluid, f.patches, v, f.c.state.nodes.p);
    const auto tangent = tangentViscosity<Dim>(flow);
    const auto L = toPoints<Dim>(f.patches, elementGradient<Dim>(f.patches, v));
    const FluidLaw& mud = *f.c.problem.fluid(0).law;
    for (int i = 0; i < f.n; ++i) {
        if (flow.mu[i] == 0) continue;  // a node of the solid
        const double g = shearRate<Dim>(L[i]), eps = 1e-6 * g;
        const double exact =
            ((g + eps) * mud.viscosity(g + eps, 0) - (g - eps) * mud.viscosity(g - eps, 0)) / (2 * eps);
        EXPECT_NEAR(tangent[i], exact, 1e-6 * flow.mu[i]);
        EXPECT_LT(tangent[i], flow.mu[i]);
    }
}

TYPED_TEST(PressureForce, uniformPressureActsAsOutwardNormalLoad) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f;
    const std::vector<double> p(f.n, 2.5);
    Points<Dim> force(f.n, Vec<Dim>::Zero());
    addPressureForce<Dim>(f.patches, p, force);
    // the internal force is minus the push of the pressure on its boundary
    Points<Dim> expected(f.n, Vec<Dim>::Zero());
    for (const auto& face : f.topology.faces)
        for (int node : face.nodes) expected[node] -= 2.5 / Dim * faceArea<Dim>(f.c.state.nodes.x, face.nodes);
    for (int i = 0; i < f.n; ++i) EXPECT_LT((force[i] - expected[i]).norm(), 1e-13);
}

TYPED_TEST(FluidMass, sumsToDensityTimesArea) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f;
    const auto mass = fluidMass<Dim>(f.c.problem, f.c.state.mesh.fluid, f.patches);
    double sum = 0;
    for (int i = 0; i < f.n; ++i) {
        EXPECT_NEAR(mass[i], 1000 * f.patches.volume[i], 1e-10);
        sum += mass[i];
    }
    EXPECT_NEAR(sum, 1000 * f.area(), 1e-9);
}

// The damping of short waves: nothing for linear velocities, it takes energy from all others, and makes no momentum.
TYPED_TEST(ZigzagForce, takesEnergyFromWhatAlternates) {
    constexpr int Dim = TypeParam::value;
    CaseOf<Dim> c = irregular<Dim>();
    const auto topology = c.topology();
    const int n = c.state.nodes.size();
    for (const auto scheme : {Integration::nodal, Integration::elemental}) {
        const auto patches =
            makeSmoothingDomains<Dim>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x, scheme);
        const auto force = [&](const Points<Dim>& v) {
            return zigzagForce<Dim>(c.problem, c.state.mesh.fluid, patches, 0.01, c.state.nodes.h,
                                    velocityGradients<Dim>(patches, v));
        };
        Points<Dim> linear(n);
        for (int i = 0; i < n; ++i) {
            const Vec<Dim>& x = c.state.nodes.x[i];
            linear[i] = Vec<Dim>::Ones() + someGradient<Dim>() * x;
        }
        const auto v = someVectors<Dim>(n, 3), w = someVectors<Dim>(n, 4);
        EXPECT_LT(largest(force(linear)), 1e-12 * largest(force(v)));
        EXPECT_GT(dot(v, force(v)), 0);
        EXPECT_NEAR(dot(w, force(v)), dot(v, force(w)), 1e-12 * dot(v, force(v)));
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (const auto& f : force(v)) sum += f;
        EXPECT_LT(sum.norm(), 1e-12 * largest(force(v)));
    }
}

}  // namespace
