// Nodal patches on irregular meshes, two materials that share an interface.

#include "integration/smoothingDomains.hpp"

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Both materials of the irregular pair with their patches.
struct Pair {
    TestCase c = irregularPair();
    Topology<2> topology = c.topology();
    SmoothingDomains<2> fluid = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x);
    SmoothingDomains<2> solid = makeSmoothingDomains<2>(c.state.mesh.solid.nodes, topology.solid, c.state.nodes.x);
    std::array<const SmoothingDomains<2>*, 2> both{&fluid, &solid};
    const Points<2>& x = c.state.nodes.x;
    int n = c.state.nodes.size();

    /// Nodes of boundary faces of one material.
    std::vector<unsigned char> boundary(const SmoothingDomains<2>& patches) const {
        std::vector<unsigned char> flag(n, 0);
        for (const auto& face : boundaryFaces<2>(*patches.cells, *patches.around))
            for (int node : face.nodes) flag[node] = 1;
        return flag;
    }
};

double polygonArea(const std::vector<Simplex<2>>& cells, const Points<2>& x) {
    // over the boundary alone: independent of how the inside is triangulated
    double area = 0;
    for (const auto& face : boundaryFaces<2>(cells, nodeToCells<2>(cells, static_cast<int>(x.size())))) {
        const Vec<2>&a = x[face.nodes[0]], &b = x[face.nodes[1]];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return area;
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

TEST(Patches, volumesSumToTheArea) {
    Pair p;
    double fluid = 0, solid = 0;
    for (int i = 0; i < p.n; ++i) {
        fluid += p.fluid.volume[i];
        solid += p.solid.volume[i];
    }
    EXPECT_NEAR(fluid, polygonArea(p.c.state.mesh.fluid.nodes, p.x), 1e-14);
    EXPECT_NEAR(solid, polygonArea(p.c.state.mesh.solid.nodes, p.x), 1e-14);
    EXPECT_NEAR(fluid, 0.5, 0.05);
    int interface = 0;
    for (int i = 0; i < p.n; ++i)
        if (p.topology.interface(i)) {
            ++interface;
            EXPECT_GT(p.fluid.volume[i], 0);
            EXPECT_GT(p.solid.volume[i], 0);
        }
    EXPECT_EQ(interface, 11);
}

TEST(Patches, uniformRateIsExactInBothPatches) {
    Pair p;
    Tensor<2> L;
    L << 0.3, -1.2, 0.8, 0.45;
    Points<2> v(p.n);
    for (int i = 0; i < p.n; ++i) v[i] = Vec<2>(3, -2) + L * p.x[i];
    for (const auto* patches : p.both) {
        const auto nodal = nodalMean<2>(*patches, elementGradient<2>(*patches, v));
        for (int i = 0; i < p.n; ++i) {
            const Tensor<2> expected = patches->volume[i] > 0 ? L : Tensor<2>(Tensor<2>::Zero());
            EXPECT_LT((nodal[i] - expected).norm(), 1e-12);
        }
        for (const auto& mean : elementMean<2>(*patches, nodal)) EXPECT_LT((mean - L).norm(), 1e-12);
    }
}

TEST(Patches, constantStressGivesNoForceInside) {
    Pair p;
    Tensor<2> sigma;
    sigma << 2, 0.7, 0.7, -1;
    for (const auto* patches : p.both) {
        Points<2> force(p.n, Vec<2>::Zero());
        addInternalForce<2>(*patches, PerCell<Tensor<2>>(patches->nCells(), sigma), force);
        const auto boundary = p.boundary(*patches);
        Points<2> expected(p.n, Vec<2>::Zero());  // on the boundary: sigma n |face|/2
        for (const auto& face : boundaryFaces<2>(*patches->cells, *patches->around))
            for (int node : face.nodes) expected[node] += 0.5 * (sigma * faceArea<2>(p.x, face.nodes));
        int inner = 0;
        for (int i = 0; i < p.n; ++i) {
            EXPECT_LT((force[i] - expected[i]).norm(), 1e-14);
            if (!boundary[i] && patches->volume[i] > 0) {
                ++inner;
                EXPECT_LT(force[i].norm(), 1e-14);
            }
        }
        EXPECT_GT(inner, 20);
    }
}

// v . F = sum_I Omega_I sigma_I : L_I for any velocities and nodal stresses: the force is the derivative of the
// strain power of the NODAL patches.
TEST(Patches, forceIsConjugateToTheNodalRates) {
    Pair p;
    const auto v = randomVectors(p.n, 1);
    const auto a = randomVectors(p.n, 2), b = randomVectors(p.n, 3);
    PerNode<Tensor<2>> sigma(p.n);
    for (int i = 0; i < p.n; ++i) sigma[i] << a[i][0], a[i][1], a[i][1], b[i][0];
    for (const auto* patches : p.both) {
        Points<2> force(p.n, Vec<2>::Zero());
        addInternalForce<2>(*patches, elementMean<2>(*patches, sigma), force);
        const auto L = nodalMean<2>(*patches, elementGradient<2>(*patches, v));
        double power = 0;
        for (int i = 0; i < p.n; ++i) power += patches->volume[i] * (sigma[i].transpose() * L[i]).trace();
        EXPECT_NEAR(dot(v, force), power, 1e-13);
        EXPECT_GT(std::abs(power), 0.01);
        Vec<2> total = Vec<2>::Zero();
        for (const auto& f : force) total += f;
        EXPECT_LT(total.norm(), 1e-13);  // no net force of internal stresses
    }
}

// The nodal gradient matrix by finite differences of L_I, and its definition element by element.
TEST(Patches, nodalGradientIsTheMeanOverThePatch) {
    Pair p;
    for (const auto* patches : p.both)
        for (int J = 0; J < p.n; J += 13) {
            Points<2> v(p.n, Vec<2>::Zero());
            v[J] = {1, 0};
            const auto L = nodalMean<2>(*patches, elementGradient<2>(*patches, v));
            for (int i = 0; i < p.n; ++i) {
                Vec<2> G = Vec<2>::Zero();
                double volume = 0;
                for (int e = 0; e < patches->nCells(); ++e) {
                    const auto& cell = patches->cell(e);
                    if (std::find(cell.begin(), cell.end(), i) == cell.end()) continue;
                    const auto g = simplexGeometry<2>(p.x, cell);
                    volume += g.measure / 3;
                    for (int k = 0; k < 3; ++k)
                        if (cell[k] == J) G += g.measure / 3 * g.gradN[k];
                }
                if (volume > 0) {
                    EXPECT_LT((L[i].row(0).transpose() - G / volume).norm(), 1e-12);
                }
            }
        }
}

TEST(Patches, uniformRateIsExactInThreeDimensions) {
    // a cube of six tetrahedra around its diagonal, its far corner moved
    Points<3> x;
    for (int i = 0; i < 8; ++i) x.push_back(Vec<3>(i & 1, (i >> 1) & 1, (i >> 2) & 1));
    x[7] += Vec<3>(0.2, 0.3, -0.1);
    const std::vector<Simplex<3>> cells = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                           {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    const auto around = nodeToCells<3>(cells, 8);
    const auto patches = makeSmoothingDomains<3>(cells, around, x);
    Tensor<3> L;
    L << 0.1, -0.5, 0.3, 0.7, 0.2, -0.9, 0.4, 0.6, -0.8;
    Points<3> v;
    double volume = 0;
    for (int i = 0; i < 8; ++i) {
        v.push_back(L * x[i]);
        volume += patches.volume[i];
    }
    double sum = 0;
    for (const auto& s : cells) {
        EXPECT_GT(simplexMeasure<3>(x, s), 0);
        sum += simplexMeasure<3>(x, s);
    }
    EXPECT_NEAR(volume, sum, 1e-14);
    for (const auto& l : nodalMean<3>(patches, elementGradient<3>(patches, v))) EXPECT_LT((l - L).norm(), 1e-12);
}

}  // namespace
