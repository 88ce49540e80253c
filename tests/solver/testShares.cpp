// What ranks work off: the ranks one after the other in this process, each with old numbers beyond its share.

#include "solver/shares.hpp"

#include <gtest/gtest.h>

#include "continuity/residual.hpp"
#include "material/herschelBulkley.hpp"
#include "momentum/consistentMass.hpp"
#include "momentum/residual.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double dt = 2e-3;

/// Water in a tank that flows somehow, and the residuals of all its nodes or of those of a share.
struct Flow {
    TestCase3 c;
    Topology<3> topology;
    NodeConstraints<3> constraints;
    Nodes<3> old, trial;

    explicit Flow(const std::shared_ptr<const FluidLaw>& law)
        : c(boxOfWater({0.5, 0.3, 0.4}, {1, 0.3, 0.8}, 0.06, "slip", 1e-3, 0.2)),
          topology(c.topology()),
          constraints(c.constraints(topology)) {
        for (auto& material : c.problem.materials) material.fluid.law = law;
        old = trial = c.state.nodes;
        const int n = trial.size();
        old.v = someVectors<3>(n, 1);
        old.p = randomNumbers(n, 2);
        trial.v = someVectors<3>(n, 3);
        trial.a = someVectors<3>(n, 4);
        trial.p = randomNumbers(n, 5);
        for (int i = 0; i < n; ++i) trial.x[i] += 1e-3 * trial.v[i];
    }
    bool isNewtonian() const { return pfem::isNewtonian<3>(c.problem); }
    int nNodes() const { return trial.size(); }
    Share part(int rank, int nRanks) const {
        std::vector<std::size_t> ends;
        for (int r = 1; r <= nRanks; ++r) ends.push_back(static_cast<std::size_t>(nNodes()) * r / nRanks);
        return partOf<3>(Ranks(), rank, ends, c.state.mesh.fluid.nodes, topology.fluid);
    }

    struct Residuals {
        std::vector<double> mass, continuity;
        Points<3> momentum;
    };
    /// `fromStart`: is the share all that is ever worked off (newtonian fluids), or from the second configuration on?
    Residuals residuals(const Share& share, bool fromStart) const {
        const auto& controls = c.controls.continuity;
        FluidPhase<3> fluid(c.problem, c.state.mesh, topology.fluid, old, Integration::nodal,
                            fromStart ? share : Share());
        const SolidPhase<3> solid(c.problem, c.controls.solid, c.state.mesh, topology.solid, old, Integration::nodal);
        const Stabilisation held{stabilisation<3>(c.problem, fluid.cells, fluid.domains, fluid.mu, old.v, dt),
                                 projectedCells<3>(controls, c.problem, fluid.cells, topology, old)};
        fluid.divide(share);
        fluid.moveTo(trial.x);
        fluid.flow(trial.v);
        const Step<3> step{c.problem, c.state.mesh, topology, constraints, old, {dt}};
        Residuals r;
        r.mass = nodalMass<3>(fluid, solid);
        auto external = viscousForces<3>(fluid, 0.3, trial);
        r.momentum = momentumResidual<3>(r.mass, trial, fluid, solid, external, 1);
        addMassDifference<3>(fluid, 1, trial.a, r.momentum);
        r.continuity = continuityResidual<3>(step, controls, fluid, held, {trial, trial, {}, Vec<3>::Zero(), {}});
        return r;
    }
};

void expectOwnNodesTheSame(const Flow& flow) {
    const auto whole = flow.residuals({}, true);
    constexpr int nRanks = 3;
    for (const bool fromStart : {flow.isNewtonian(), false})
        for (int rank = 0; rank < nRanks; ++rank) {
            const Share share = flow.part(rank, nRanks);
            EXPECT_LT(static_cast<int>(share.nodes().size()), flow.nNodes()) << "a part of the nodes";
            const auto own = flow.residuals(share, fromStart);
            for (std::size_t i = rank == 0 ? 0 : share.ends()[rank - 1]; i < share.ends()[rank]; ++i) {
                EXPECT_EQ(own.mass[i], whole.mass[i]) << i;
                EXPECT_EQ(own.momentum[i], whole.momentum[i]) << i;
                EXPECT_EQ(own.continuity[i], whole.continuity[i]) << i;
            }
        }
}

}  // namespace

TEST(Shares, residualsOfOwnNodes) { expectOwnNodesTheSame(Flow(newtonian(2))); }

TEST(Shares, residualsOfOwnNodesWithAViscosityOfTheFlow) {
    expectOwnNodesTheSame(Flow(herschelBulkley({2, 0.6, 20, 0.5})));
}

TEST(Shares, sumsAndFirsts) {
    const Share all, part(Ranks(), {4}, {0, 1, 2, 3}, {0, 2, 5});
    const auto value = [](int i) { return 1.0 / (i + 1); };
    EXPECT_EQ(all.sum(3000, value), part.sum(3000, value));
    EXPECT_EQ(all.sum(3000, value), parallelSum(3000, value));
    EXPECT_EQ(all.firstCell(6, [](int e) { return e > 2; }), 3);
    EXPECT_EQ(part.firstCell(6, [](int e) { return e > 2; }), 5);
    EXPECT_EQ(part.firstCell(6, [](int e) { return e > 5; }), 6);
    int count = 0;
    part.forCells(6, [&](int e) { count += e; });
    EXPECT_EQ(count, 7);
}
