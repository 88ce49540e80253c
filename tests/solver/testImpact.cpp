// A new contact as an inelastic impact: closed forms of what impulses along the gradients of a cell must keep.

#include <gtest/gtest.h>

#include "momentum/mass.hpp"
#include "solver/impact.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Nodal masses, from the operators of the momentum equation.
std::vector<double> massOf(const TestCase& c) {
    const auto topology = c.topology();
    const auto fluid = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x);
    return fluidMass<2>(c.problem, c.state.mesh.fluid, fluid);
}

struct Motion {
    Vec<2> momentum = Vec<2>::Zero();
    double moment = 0, energy = 0;
};
Motion motionOf(const TestCase& c) {
    Motion m;
    const auto mass = massOf(c);
    const auto& nodes = c.state.nodes;
    for (int i = 0; i < nodes.size(); ++i) {
        m.momentum += mass[i] * nodes.v[i];
        m.moment += mass[i] * (nodes.x[i][0] * nodes.v[i][1] - nodes.x[i][1] * nodes.v[i][0]);
        m.energy += 0.5 * mass[i] * nodes.v[i].squaredNorm();
    }
    return m;
}

double divergence(const TestCase& c, const Simplex<2>& s) {
    return simplexDivergence<2>(c.state.nodes.x, c.state.nodes.v, s);
}

/// Velocities that close each cell at 3/s and turn it.
void closeCells(TestCase& c) {
    Tensor<2> L;
    L << -2, 5, -3, -1;
    for (int i = 0; i < c.state.nodes.size(); ++i) c.state.nodes.v[i] = Vec<2>(0.3, -0.2) + L * c.state.nodes.x[i];
}

/// Water with an irregular mesh and a surface of its own.
TestCase water01() {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) + " } );", water, "");
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.015, 0.015);
    for (auto& x : c.state.nodes.x) x += Vec<2>(shift(random), shift(random));
    closeCells(c);
    return c;
}

TEST(Impact, stopsTheClosingAndKeepsMomentumAndItsMoment) {
    TestCase c = water01();
    const std::vector<Simplex<2>> contacts{c.state.mesh.fluid.nodes[17]};
    const auto before = motionOf(c);
    const auto v = c.state.nodes.v;
    EXPECT_NEAR(divergence(c, contacts[0]), -3, 1e-9);
    strike<2>(c.problem, contacts, c.state);
    const auto after = motionOf(c);
    EXPECT_NEAR(divergence(c, contacts[0]), 0, 1e-10);
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-11 * before.momentum.norm());
    EXPECT_NEAR(after.moment, before.moment, 1e-11 * std::abs(before.moment));
    EXPECT_LT(after.energy, before.energy);

    // the loss is that of an inelastic impact: lambda = -div/(sum |grad N|^2/m), loss = lambda div/2
    const auto g = simplexGeometry<2>(c.state.nodes.x, contacts[0]);
    const auto mass = massOf(c);
    double mobility = 0;
    for (int k = 0; k < 3; ++k) mobility += g.gradN[k].squaredNorm() / mass[contacts[0][k]];
    EXPECT_NEAR(before.energy - after.energy, 0.5 * 9 / mobility, 1e-8 * before.energy);
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (std::find(contacts[0].begin(), contacts[0].end(), i) == contacts[0].end()) {
            EXPECT_EQ(c.state.nodes.v[i], v[i]);
        }
}

// Elastic walls get their impulse from the pressure: an impulse to single nodes would only make them tremble.
TEST(Impact, solidsAreNotStruck) {
    TestCase c = irregularPair();
    closeCells(c);
    const auto v = c.state.nodes.v;
    const auto topology = c.topology();
    std::vector<Simplex<2>> contacts;
    for (const auto& s : c.state.mesh.fluid.nodes)
        if (std::any_of(s.begin(), s.end(), [&](int i) { return topology.onSolid[i]; })) contacts.push_back(s);
    ASSERT_GT(contacts.size(), 5u);
    strike<2>(c.problem, contacts, c.state);
    EXPECT_EQ(c.state.nodes.v, v);
}

TEST(Impact, contactsThatShareNodes) {
    TestCase c = water01();
    const auto& cells = c.state.mesh.fluid.nodes;
    const std::vector<Simplex<2>> contacts(cells.begin() + 20, cells.begin() + 24);
    const auto before = motionOf(c);
    strike<2>(c.problem, contacts, c.state);
    for (const auto& s : contacts) EXPECT_GT(divergence(c, s), -0.031);  // to 1 % of 3/s
    const auto after = motionOf(c);
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-11 * before.momentum.norm());
    EXPECT_LT(after.energy, before.energy);
}

TEST(Impact, cellsThatOpenStayAsTheyAre) {
    TestCase c = water01();
    for (auto& v : c.state.nodes.v) v = -v;
    const auto v = c.state.nodes.v;
    strike<2>(c.problem, {c.state.mesh.fluid.nodes[3]}, c.state);
    EXPECT_EQ(c.state.nodes.v, v);
}

// A cell with one node on a wall that it sticks to: the two free nodes take the whole impulse.
TEST(Impact, whatSticksTakesNoImpulse) {
    TestCase c = makeCase("meshSize 0.25; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( floor { points ((0 0) (1 0)); } );",
                          water, "floor { type noSlip; }");
    auto& nodes = c.state.nodes;
    std::vector<Simplex<2>> contacts;
    int stuck = -1;
    for (const auto& s : c.state.mesh.fluid.nodes) {
        const auto onFloor = [&](int i) { return nodes.x[i][1] < 1e-9; };
        if (std::count_if(s.begin(), s.end(), onFloor) != 1 || !contacts.empty()) continue;
        stuck = *std::find_if(s.begin(), s.end(), onFloor);
        if (nodes.x[stuck][0] > 1e-9 && nodes.x[stuck][0] < 1 - 1e-9) contacts.push_back(s);
    }
    ASSERT_EQ(contacts.size(), 1u);
    for (int i : contacts[0]) nodes.v[i] = nodes.x[stuck] - nodes.x[i];
    EXPECT_LT(divergence(c, contacts[0]), -1);
    strike<2>(c.problem, contacts, c.state);
    EXPECT_NEAR(divergence(c, contacts[0]), 0, 1e-10);
    EXPECT_EQ(nodes.v[stuck], (Vec<2>(0, 0)));
}

// Water in a corner of walls: the corner takes all, nodes that slide keep to their wall, those that stick take nothing.
TEST(Impact, wallsHold) {
    for (const std::string kind : {"slip", "noSlip"}) {
        TestCase c = makeCase("meshSize 0.25; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                                  " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                              water, "tank { type " + kind + "; }");
        auto& nodes = c.state.nodes;
        const auto constraints = c.constraints(c.topology());
        const auto isCorner = [&](int i) { return nodes.x[i].norm() < 1e-9; };
        std::vector<Simplex<2>> contacts;
        int slides = 0;
        for (const auto& s : c.state.mesh.fluid.nodes) {
            if (std::none_of(s.begin(), s.end(), isCorner) || !contacts.empty()) continue;
            contacts.push_back(s);
            for (int i : s) {
                nodes.v[i] = kind == "slip"               ? constraints.project(i, -nodes.x[i])
                             : isSupported(nodes.wall[i]) ? Vec<2>(0, 0)
                                                          : Vec<2>(-nodes.x[i]);
                slides += nSupports(nodes.wall[i]) == 1;
            }
        }
        EXPECT_GT(slides, 0);
        const auto v = nodes.v;
        const bool closes = divergence(c, contacts.at(0)) < -0.1;
        EXPECT_EQ(closes, kind == "slip" || slides < 2);
        strike<2>(c.problem, contacts, c.state);
        if (closes) {
            EXPECT_NEAR(divergence(c, contacts[0]), 0, 1e-10);
        }
        for (int i = 0; i < nodes.size(); ++i) {
            EXPECT_LT((nodes.v[i] - constraints.project(i, nodes.v[i])).norm(), 1e-14) << nodes.x[i].transpose();
            if (isSupported(nodes.wall[i]) && kind == "noSlip") {
                EXPECT_EQ(nodes.v[i], v[i]);
            }
        }
    }
}

}  // namespace
