// Nodal patches on irregular meshes, two materials that share an interface.

#include "integration/smoothingDomains.hpp"

#include <gtest/gtest.h>

#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

PFEM_BOTH_DIMENSIONS(Patches);

/// Both materials of the irregular pair with their patches.
template <int Dim>
struct Pair {
    CaseOf<Dim> c = irregular<Dim>();
    Topology<Dim> topology = c.topology();
    SmoothingDomains<Dim> fluid = makeSmoothingDomains<Dim>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x);
    SmoothingDomains<Dim> solid = makeSmoothingDomains<Dim>(c.state.mesh.solid.nodes, topology.solid, c.state.nodes.x);
    std::array<const SmoothingDomains<Dim>*, 2> both{&fluid, &solid};
    const Points<Dim>& x = c.state.nodes.x;
    int n = c.state.nodes.size();

    /// Nodes of boundary faces of one material.
    std::vector<unsigned char> boundary(const SmoothingDomains<Dim>& patches) const {
        std::vector<unsigned char> flag(n, 0);
        for (const auto& face : boundaryFaces<Dim>(*patches.cells, *patches.around))
            for (int node : face.nodes) flag[node] = 1;
        return flag;
    }
};

/// int x . n/Dim over the boundary alone: independent of how the inside is meshed.
template <int Dim>
double enclosed(const std::vector<Simplex<Dim>>& cells, const Points<Dim>& x) {
    double measure = 0;
    for (const auto& face : boundaryFaces<Dim>(cells, nodeToCells<Dim>(cells, static_cast<int>(x.size()))))
        measure += x[face.nodes[0]].dot(faceArea<Dim>(x, face.nodes)) / Dim;
    return measure;
}

// Four points near a square have no node near another; terms with |e| |grad N|^2 would grow with the inverse of the
// height t. What sliverFactor leaves of them falls with t.
TEST(Simplex, sliversCountLess) {
    const auto term = [](double t, bool whole) {
        const Points<3> x = {{0, 0, 0}, {1, 0, t}, {1, 1, 0}, {0, 1, t}};
        const auto g = simplexGeometry<3>(x, {0, 1, 3, 2});
        return std::abs(g.measure) * g.gradN[0].squaredNorm() * (whole ? 1 : sliverFactor<3>(g));
    };
    EXPECT_GT(term(0.001, true), 5 * term(0.01, true));
    EXPECT_LT(term(0.001, false), term(0.01, false));
    EXPECT_LT(term(0.0001, false), 0.3 * term(0.001, false));
    const Points<3> regular = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    EXPECT_EQ(sliverFactor<3>(simplexGeometry<3>(regular, {0, 1, 2, 3})), 1);
    const Points<2> flat = {{0, 0}, {1, 0}, {0.5, 1e-6}};
    EXPECT_EQ(sliverFactor<2>(simplexGeometry<2>(flat, {0, 1, 2})), 1);
}

TEST(Simplex, gradientsAreDerivativesOfTheMeasure) {
    // d|e|/dx_k = |e| grad N_k
    const Points<2> x2 = {{0.1, 0.2}, {1.3, 0.1}, {0.4, 0.9}};
    const Points<3> x3 = {{0, 0.1, 0.2}, {1.1, 0, 0.1}, {0.2, 1.3, 0}, {0.1, 0.2, 0.8}};
    const auto check = [](const auto& x, auto dim) {
        constexpr int D = decltype(dim)::value;
        Simplex<D> s;
        for (int k = 0; k <= D; ++k) s[k] = k;
        const auto g = simplexGeometry<D>(x, s);
        ASSERT_GT(g.measure, 0);
        EXPECT_NEAR(g.measure, simplexMeasure<D>(x, s), 1e-15);
        for (int k = 0; k <= D; ++k)
            for (int d = 0; d < D; ++d) {
                auto plus = x, minus = x;
                plus[k][d] += 1e-5;
                minus[k][d] -= 1e-5;
                const double slope = (simplexMeasure<D>(plus, s) - simplexMeasure<D>(minus, s)) / 2e-5;
                EXPECT_NEAR(slope, g.measure * g.gradN[k][d], 1e-10);
                for (int l = 0; l <= D; ++l)  // N_k is 1 at its node and 0 at the others
                    EXPECT_NEAR(g.gradN[k].dot(x[l] - x[(k + 1) % (D + 1)]), l == k ? 1.0 : 0.0, 1e-13);
            }
        Vec<D> closed = Vec<D>::Zero();  // faces close the simplex, and grad N_k = -area_k/(D |e|)
        for (int k = 0; k <= D; ++k) {
            const Vec<D> area = faceArea<D>(x, oppositeFace<D>(s, k));
            closed += area;
            EXPECT_LT((g.gradN[k] + area / (D * g.measure)).norm(), 1e-12);
        }
        EXPECT_LT(closed.norm(), 1e-15);
    };
    check(x2, std::integral_constant<int, 2>());
    check(x3, std::integral_constant<int, 3>());
}

TYPED_TEST(Patches, volumesSumToWhatTheBoundaryEncloses) {
    constexpr int Dim = TypeParam::value;
    Pair<Dim> p;
    double fluid = 0, solid = 0;
    for (int i = 0; i < p.n; ++i) {
        fluid += p.fluid.volume[i];
        solid += p.solid.volume[i];
    }
    EXPECT_NEAR(fluid, enclosed<Dim>(p.c.state.mesh.fluid.nodes, p.x), 1e-14);
    EXPECT_NEAR(solid, enclosed<Dim>(p.c.state.mesh.solid.nodes, p.x), 1e-14);
    EXPECT_NEAR(fluid, 0.5, 0.05);
    int interface = 0;
    for (int i = 0; i < p.n; ++i)
        if (p.topology.interface(i)) {
            ++interface;
            EXPECT_GT(p.fluid.volume[i], 0);
            EXPECT_GT(p.solid.volume[i], 0);
        }
    EXPECT_EQ(interface, Dim == 2 ? 11 : 25);
}

TYPED_TEST(Patches, uniformRateIsExactInBothPatches) {
    constexpr int Dim = TypeParam::value;
    Pair<Dim> p;
    const Tensor<Dim> L = someGradient<Dim>();
    Points<Dim> v(p.n);
    for (int i = 0; i < p.n; ++i) v[i] = Vec<Dim>::LinSpaced(3, -2) + L * p.x[i];
    for (const auto* patches : p.both) {
        const auto nodal = nodalMean<Dim>(*patches, elementGradient<Dim>(*patches, v));
        for (int i = 0; i < p.n; ++i) {
            const Tensor<Dim> expected = patches->volume[i] > 0 ? L : Tensor<Dim>(Tensor<Dim>::Zero());
            EXPECT_LT((nodal[i] - expected).norm(), 1e-12);
        }
        for (const auto& mean : elementMean<Dim>(*patches, nodal)) EXPECT_LT((mean - L).norm(), 1e-12);
    }
}

TYPED_TEST(Patches, constantStressGivesNoForceInside) {
    constexpr int Dim = TypeParam::value;
    Pair<Dim> p;
    const Tensor<Dim> sigma = corner<Dim>({2, 0.7, -0.3, 0.7, -1, 0.4, -0.3, 0.4, 1.5});
    for (const auto* patches : p.both) {
        Points<Dim> force(p.n, Vec<Dim>::Zero());
        addInternalForce<Dim>(*patches, PerCell<Tensor<Dim>>(patches->nCells(), sigma), force);
        const auto boundary = p.boundary(*patches);
        Points<Dim> expected(p.n, Vec<Dim>::Zero());  // on the boundary: sigma n |face|/d
        for (const auto& face : boundaryFaces<Dim>(*patches->cells, *patches->around))
            for (int node : face.nodes) expected[node] += sigma * faceArea<Dim>(p.x, face.nodes) / Dim;
        int inner = 0;
        for (int i = 0; i < p.n; ++i) {
            EXPECT_LT((force[i] - expected[i]).norm(), 1e-14);
            if (!boundary[i] && patches->volume[i] > 0) {
                ++inner;
                EXPECT_LT(force[i].norm(), 1e-14);
            }
        }
        EXPECT_GT(inner, Dim == 2 ? 20 : 8);
    }
}

// v . F = sum_I Omega_I sigma_I : L_I for any velocities and nodal stresses: the force is the derivative of the
// strain power of the NODAL patches.
TYPED_TEST(Patches, forceIsConjugateToTheNodalRates) {
    constexpr int Dim = TypeParam::value;
    Pair<Dim> p;
    const auto v = someVectors<Dim>(p.n, 1);
    const auto a = someVectors<Dim>(p.n, 2), b = someVectors<Dim>(p.n, 3);
    PerNode<Tensor<Dim>> sigma(p.n);
    for (int i = 0; i < p.n; ++i) sigma[i] = a[i] * b[i].transpose() + b[i] * a[i].transpose();
    for (const auto* patches : p.both) {
        Points<Dim> force(p.n, Vec<Dim>::Zero());
        addInternalForce<Dim>(*patches, elementMean<Dim>(*patches, sigma), force);
        const auto L = nodalMean<Dim>(*patches, elementGradient<Dim>(*patches, v));
        double power = 0;
        for (int i = 0; i < p.n; ++i) power += patches->volume[i] * (sigma[i].transpose() * L[i]).trace();
        EXPECT_NEAR(dot(v, force), power, 1e-13);
        EXPECT_GT(std::abs(power), 0.01);
        Vec<Dim> total = Vec<Dim>::Zero();
        for (const auto& f : force) total += f;
        EXPECT_LT(total.norm(), 1e-13);  // no net force of internal stresses
    }
}

// The nodal gradient matrix by finite differences of L_I, and its definition element by element.
TYPED_TEST(Patches, nodalGradientIsTheMeanOverThePatch) {
    constexpr int Dim = TypeParam::value;
    Pair<Dim> p;
    for (const auto* patches : p.both)
        for (int J = 0; J < p.n; J += 13) {
            Points<Dim> v(p.n, Vec<Dim>::Zero());
            v[J] = Vec<Dim>::UnitX();
            const auto L = nodalMean<Dim>(*patches, elementGradient<Dim>(*patches, v));
            for (int i = 0; i < p.n; ++i) {
                Vec<Dim> G = Vec<Dim>::Zero();
                double volume = 0;
                for (int e = 0; e < patches->nCells(); ++e) {
                    const auto& cell = patches->cell(e);
                    if (std::find(cell.begin(), cell.end(), i) == cell.end()) continue;
                    const auto g = simplexGeometry<Dim>(p.x, cell);
                    volume += g.measure / (Dim + 1);
                    for (int k = 0; k <= Dim; ++k)
                        if (cell[k] == J) G += g.measure / (Dim + 1) * g.gradN[k];
                }
                if (volume > 0) {
                    EXPECT_LT((L[i].row(0).transpose() - G / volume).norm(), 1e-12);
                }
            }
        }
}

}  // namespace
