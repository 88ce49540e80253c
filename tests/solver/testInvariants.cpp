// Each way in which an accepted state could be wrong is noticed, named and placed; a good one passes.

#include "solver/invariants.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "solver/failedStep.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Invariants : public testing::Test {
protected:
    void SetUp() override {
        c_.start(1e-3);
        last_ = c_.state;
        c_.step(1e-3);
        next_ = c_.state;
    }
    /// What is said about `next_`; "" when it passes.
    std::string complaint() const {
        try {
            checkInvariants<2>(c_.controls.convergence,
                               makeTopology<2>(last_.mesh, c_.kinds(), last_.nodes.x, last_.nodes.wall), last_, next_);
        } catch (const StepFailure& failure) {
            return failure.what();
        }
        return "";
    }
    int fluidNode() const {  // inside the fluid
        return nearestNode(next_.nodes.x, {0.2, 0.2});
    }

    TestCase c_ = waterBesideStep();
    State<2> last_, next_;
};

TEST_F(Invariants, AGoodStepPasses) { EXPECT_EQ(complaint(), ""); }

TEST_F(Invariants, NotFinite) {
    next_.nodes.v[fluidNode()][1] = nan;
    EXPECT_NE(complaint().find("not finite"), std::string::npos);
    EXPECT_NE(complaint().find("node " + std::to_string(next_.nodes.id[fluidNode()]) + " at (0."), std::string::npos);
}

TEST_F(Invariants, InvertedElements) {
    const State<2> good = next_;
    std::swap(next_.mesh.solid.nodes[0][0], next_.mesh.solid.nodes[0][1]);
    EXPECT_NE(complaint().find("solid element"), std::string::npos);
    next_ = good;
    std::swap(next_.mesh.fluid.nodes[0][0], next_.mesh.fluid.nodes[0][1]);
    EXPECT_NE(complaint().find("fluid element"), std::string::npos);
}

/// A particle on its own, so that no element is inverted.
int addDrop(State<2>& state, const Vec<2>& x) {
    state.nodes.append(state.nodes, state.nodes.size() - 1);
    state.nodes.id.back() += 1;
    state.nodes.x.back() = x;
    state.nodes.wall.back() = unsupported<2>();
    state.nodes.v.back().setZero();
    return state.nodes.size() - 1;
}

TEST_F(Invariants, ThroughAWall) {
    addDrop(last_, {0.9, 0.01});
    const int drop = addDrop(next_, {0.9, 0.005});
    EXPECT_EQ(complaint(), "");
    next_.nodes.x[drop] = {0.9, -0.01};
    EXPECT_NE(complaint().find("went through the wall 'tank'"), std::string::npos);
    last_.nodes.x[last_.nodes.size() - 1] = {0.9, 0};  // from the wall itself
    EXPECT_NE(complaint().find("went through the wall 'tank'"), std::string::npos);
    last_.nodes.x[last_.nodes.size() - 1] = {0.9, -1e-5};  // it came round an end and creeps along the back
    EXPECT_EQ(complaint(), "");
    last_.nodes.x[last_.nodes.size() - 1] = {0.9, -0.5};  // it was outside before
    EXPECT_EQ(complaint(), "");
    last_.nodes.x[last_.nodes.size() - 1] = {1.2, 0.01};  // around the end of the wall
    EXPECT_EQ(complaint(), "");
}

TEST_F(Invariants, ThroughASolid) {
    addDrop(last_, {0.65, 0.1});
    const int drop = addDrop(next_, {0.62, 0.1});
    EXPECT_EQ(complaint(), "");
    next_.nodes.x[drop] = {0.39, 0.1};  // the step is from 0.4 to 0.6
    EXPECT_NE(complaint().find("went through a solid"), std::string::npos);
    last_.nodes.x[last_.nodes.size() - 1] = {0.65, 0.9};  // high over it
    next_.nodes.x[drop] = {0.39, 0.9};
    EXPECT_EQ(complaint(), "");
}

TEST_F(Invariants, Volume) {
    next_.nodes.dropVolume.back() = 0.05 * cellVolume<2>(next_.nodes.x, next_.mesh.fluid.nodes);
    EXPECT_EQ(complaint(), "");
    next_.nodes.dropVolume.back() *= 3;
    EXPECT_NE(complaint().find("volume changed"), std::string::npos);
}

TEST_F(Invariants, Speed) {
    checkSpeed<2>(c_.controls.convergence, next_.nodes);
    next_.nodes.v[fluidNode()] = {1e12, 0};
    EXPECT_THROW(checkSpeed<2>(c_.controls.convergence, next_.nodes), StepFailure);
}

// Contacts, landing and remeshing make nobody faster than the fastest before, but for what moving walls and solids
// push.
TEST_F(Invariants, SpeedGain) {
    auto& nodes = next_.nodes;
    const auto topology = makeTopology<2>(next_.mesh, c_.kinds(), nodes.x, nodes.wall);
    for (auto& v : nodes.v) v = Vec<2>::Zero();
    nodes.v[fluidNode()] = {3, 4};
    const double allowed = allowedSpeed<2>(topology, nodes);
    EXPECT_NEAR(allowed, 5, 1e-12);
    checkSpeedGain<2>(allowed, nodes);
    nodes.v[fluidNode()] = {3, 4.0001};
    EXPECT_THROW(checkSpeedGain<2>(allowed, nodes), StepFailure);
    nodes.v[next_.mesh.solid.nodes[0][0]] = {0.5, 0};
    EXPECT_NEAR(allowedSpeed<2>(topology, nodes), std::hypot(3, 4.0001) + 1, 1e-12);
}

// What is written for inspection is finite, keeps what was there, and flags the culprit.
TEST_F(Invariants, Inspection) {
    const int i = fluidNode();
    State<2> trial = next_;
    trial.nodes.x[i] = {nan, 0};
    trial.nodes.p[i] = std::numeric_limits<double>::infinity();
    const auto found = inspect<2>(FailedStep<2>(StepFailure("why"), trial), last_);
    EXPECT_EQ(found.state.nodes.x[i], last_.nodes.x[i]);
    EXPECT_EQ(found.state.nodes.p[i], 0);
    EXPECT_EQ(std::count(found.failed.begin(), found.failed.end(), 1), 1);
    EXPECT_EQ(found.failed[i], 1);
    EXPECT_NE(found.text.find("node " + std::to_string(trial.nodes.id[i])), std::string::npos);

    const auto named = inspect<2>(FailedStep<2>(StepFailure("why", {trial.nodes.id[3]}), next_), last_);
    EXPECT_EQ(named.failed[3], 1);
}

// After a rejected step the steps become longer again; the state is untouched by the tries.
TEST_F(Invariants, RejectedTriesLeaveNoTrace) {
    TestCase small = c_;
    c_.state.nodes.v[fluidNode()] = {3000, 0};  // no step of 1e-3 s can do that
    small.state = c_.state;
    const auto report = c_.step(1e-3);
    EXPECT_GT(report.rejected, 0);
    EXPECT_EQ(static_cast<int>(report.reasons.size()), report.rejected);
    EXPECT_EQ(report.dt, 1e-3 / (1 << report.rejected));
    small.step(report.dt);
    EXPECT_EQ(small.state.nodes.x, c_.state.nodes.x);
}

}  // namespace
