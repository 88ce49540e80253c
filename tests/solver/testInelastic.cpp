// Random contacts: whatever meets and whatever holds it, the cell no longer closes, nobody becomes faster and
// no energy is made.

#include "solver/inelastic.hpp"

#include <gtest/gtest.h>

#include "momentum/mass.hpp"
#include "solver/impact.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A rigid motion: what holds the nodes of a cell.
struct Rigid {
    Vec<2> velocity = Vec<2>::Zero();
    double omega = 0;
    Vec<2> at(const Vec<2>& x) const { return velocity + omega * Vec<2>(-x[1], x[0]); }
};

class RandomCells {
public:
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    Vec<2> direction() {
        const double angle = number(0, 2 * M_PI);
        return {std::cos(angle), std::sin(angle)};
    }

    /// Regular and flat ones, masses over nine decades, nodes that are free, slide or are fixed.
    MeetingCell<2> next(const Rigid& holds) {
        MeetingCell<2> cell;
        Points<2> x(3);
        do {
            for (auto& p : x) p = {number(-1, 1), number(-1, 1) * flatness_};
        } while (!(simplexMeasure<2>(x, {0, 1, 2}) > 1e-9));
        flatness_ = std::pow(10.0, number(-5, 0));
        cell.gradN = simplexGeometry<2>(x, {0, 1, 2}).gradN;
        const Vec<2> n = direction();  // half of the sliding nodes have the same wall
        for (int k = 0; k < 3; ++k) {
            cell.x[k] = x[k];
            cell.mass[k] = std::pow(10.0, number(-9, 0));
            cell.v[k] = holds.velocity + number(0, 3) * direction();
            const Vec<2> normal = number(0, 1) < 0.5 ? n : direction();
            const int hold = static_cast<int>(number(0, 5));  // 0, 1, 2: free
            cell.freedom[k].setIdentity();
            if (hold == 3) cell.freedom[k] -= normal * normal.transpose();
            if (hold == 4) cell.freedom[k].setZero();
            cell.v[k] = cell.freedom[k] * cell.v[k] + heldPart(cell, k) * holds.at(x[k]);
        }
        return cell;
    }

    static Tensor<2> heldPart(const MeetingCell<2>& cell, int k) { return Tensor<2>::Identity() - cell.freedom[k]; }

private:
    std::mt19937 random_{7};
    double flatness_ = 1;
};

double energyOf(const MeetingCell<2>& cell, const Rigid& frame) {
    double energy = 0;
    for (int k = 0; k < 3; ++k) energy += 0.5 * cell.mass[k] * (cell.v[k] - frame.at(cell.x[k])).squaredNorm();
    return energy;
}

double fastestOf(const MeetingCell<2>& cell, const Rigid& frame) {
    double fastest = 0;
    for (int k = 0; k < 3; ++k) fastest = std::max(fastest, (cell.v[k] - frame.at(cell.x[k])).norm());
    return fastest;
}

/// Seen from what holds a cell (without any hold: from where we are).
void expectInelastic(const MeetingCell<2>& before, const MeetingCell<2>& after, const Rigid& frame) {
    const double fastest = fastestOf(before, frame), energy = energyOf(before, frame);
    double steepest = 0;
    for (const auto& g : before.gradN) steepest = std::max(steepest, g.norm());
    EXPECT_NEAR(after.divergence(), 0, 1e-7 * steepest * (fastest + frame.velocity.norm()));
    EXPECT_LE(fastestOf(after, frame), fastest * (1 + 1e-9));
    EXPECT_LE(energyOf(after, frame), energy * (1 + 1e-9));
    bool free = true;
    Vec<2> gained = Vec<2>::Zero();
    double mass = 0;
    for (int k = 0; k < 3; ++k) {
        EXPECT_LT((RandomCells::heldPart(before, k) * (after.v[k] - before.v[k])).norm(), 1e-12 * fastest);
        free = free && before.freedom[k].isIdentity();
        gained += before.mass[k] * (after.v[k] - before.v[k]);
        mass += before.mass[k];
    }
    if (free) {
        EXPECT_LT(gained.norm(), 1e-12 * mass * fastest);
    }
}

TEST(Inelastic, RandomContacts) {
    RandomCells cells;
    int struck = 0, thrown = 0;
    for (int n = 0; n < 20000; ++n) {
        const MeetingCell<2> before = cells.next({});
        MeetingCell<2> after = before;
        if (!stopClosing<2>(after)) {
            EXPECT_EQ(after.v, before.v);
            continue;
        }
        ++struck;
        expectInelastic(before, after, {});
        double mobility = 0;  // what the impulses alone would do
        for (int k = 0; k < 3; ++k)
            mobility += before.gradN[k].dot(before.freedom[k] * before.gradN[k]) / before.mass[k];
        MeetingCell<2> alone = before;
        for (int k = 0; k < 3; ++k)
            alone.v[k] -= before.divergence() / mobility * before.freedom[k] * before.gradN[k] / before.mass[k];
        thrown += fastestOf(alone, {}) > 10 * fastestOf(before, {});
    }
    EXPECT_GT(struck, 5000);
    EXPECT_GT(thrown, 50);  // such contacts are among them
}

/// Do the holds say all about the wall's motion, its turn included? A fixed node and another one that may not
/// turn about it do.
bool saysAll(const MeetingCell<2>& cell) {
    for (int k = 0; k < 3; ++k)
        for (int j = 0; cell.freedom[k].isZero() && j < 3; ++j) {
            const Vec<2> r = cell.x[j] - cell.x[k];
            if ((RandomCells::heldPart(cell, j) * Vec<2>(-r[1], r[0])).norm() > 1e-3) return true;
        }
    return false;
}

// Walls that move and turn as one: the same, seen from them.
TEST(Inelastic, RandomContactsOnAMovingWall) {
    RandomCells cells;
    int struck = 0;
    for (int n = 0; n < 20000; ++n) {
        const Rigid wall{cells.number(0, 5) * cells.direction(), n % 2 == 0 ? 0 : cells.number(-3, 3)};
        const MeetingCell<2> before = cells.next(wall);
        MeetingCell<2> after = before;
        if (!saysAll(before) || !stopClosing<2>(after)) continue;
        ++struck;
        expectInelastic(before, after, wall);
    }
    EXPECT_GT(struck, 1000);
}

// Two heavy nodes meet, one near the end of an edge, the light node at its other end: impulses alone would
// throw it with 20 m/s.
TEST(Inelastic, ALightNodeIsNotThrown) {
    MeetingCell<2> cell;
    const Points<2> x{{0.05, 0.1}, {0, 0}, {1, 0}};
    cell.gradN = simplexGeometry<2>(x, {0, 1, 2}).gradN;
    cell.x = {x[0], x[1], x[2]};
    cell.v = {Vec<2>(0, -1), Vec<2>(0, 0), Vec<2>(0, 0)};
    cell.mass = {1, 1, 1e-6};
    for (auto& f : cell.freedom) f.setIdentity();
    EXPECT_TRUE(stopClosing<2>(cell));
    EXPECT_NEAR(cell.divergence(), 0, 1e-9);
    EXPECT_LE(fastestOf(cell, {}), 1 + 1e-12);
    EXPECT_NEAR((cell.mass[0] * cell.v[0] + cell.mass[1] * cell.v[1] + cell.mass[2] * cell.v[2] - Vec<2>(0, -1)).norm(),
                0, 1e-12);
}

TEST(Inelastic, HoldsThatMoveToEachOtherAreLeft) {
    MeetingCell<2> cell;
    const Points<2> x{{0, 1}, {0, 0}, {1, 0}};
    cell.gradN = simplexGeometry<2>(x, {0, 1, 2}).gradN;
    cell.x = {x[0], x[1], x[2]};
    cell.v = {Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(-1, 0)};
    cell.mass = {1, 1, 1};
    cell.freedom = {Tensor<2>::Identity(), Tensor<2>::Zero(), Tensor<2>::Zero()};
    const auto v = cell.v;
    EXPECT_FALSE(stopClosing<2>(cell));
    EXPECT_EQ(cell.v, v);
}

// Cells of a mesh with walls, several at a time, light and heavy nodes, contact lines on the walls.
TEST(Inelastic, RandomContactsThatShareNodes) {
    std::mt19937 random(3);
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (const std::string kind : {"slip", "noSlip"}) {
        const TestCase whole =
            makeCase("meshSize 0.125; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                         " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                     water, "tank { type " + kind + "; }");
        int struck = 0;
        for (int n = 0; n < 500; ++n) {
            TestCase c = whole;
            auto& nodes = c.state.nodes;
            const double part = number(0.2, 1);  // of the cells: drops, films, contact lines
            std::erase_if(c.state.mesh.fluid.nodes, [&](const auto&) { return number(0, 1) > part; });
            c.state.mesh.fluid.material.resize(c.state.mesh.fluid.nodes.size());
            const auto topology = c.topology();
            for (int i = 0; i < nodes.size(); ++i)  // along walls the nodes come near to each other
                if (!topology.wallPoint[i])
                    nodes.x[i] += c.constraints(topology).project(i, Vec<2>(number(-0.04, 0.04), number(-0.04, 0.04)));
            std::vector<Simplex<2>> contacts;
            for (const auto& s : c.state.mesh.fluid.nodes)
                if (number(0, 1) < 0.3 && simplexMeasure<2>(nodes.x, s) > 1e-6) contacts.push_back(s);
            std::erase_if(c.state.mesh.fluid.nodes,
                          [&](const auto& s) { return !(simplexMeasure<2>(nodes.x, s) > 1e-6); });
            c.state.mesh.fluid.material.resize(c.state.mesh.fluid.nodes.size());
            const auto now = c.topology();
            const auto constraints = c.constraints(now);
            for (int i = 0; i < nodes.size(); ++i) {
                nodes.v[i] = {number(-2, 2), number(-2, 2)};
                // what has just been covered still has the velocity with which it crept
                if (now.onWall[i])
                    for (const int w : now.supports[i])
                        if (w >= 0) {
                            const Vec<2> normal = inwardNormal<2>(nodes.x, now.walls[w].nodes);
                            nodes.v[i] -= normal * normal.dot(nodes.v[i]);
                        }
                if (now.wallPoint[i]) nodes.v[i].setZero();
            }
            const auto mass = fluidMass<2>(c.problem, c.state.mesh.fluid, nodes.x);
            const auto energy = [&] {
                double sum = 0;
                for (int i = 0; i < nodes.size(); ++i) sum += 0.5 * mass[i] * nodes.v[i].squaredNorm();
                return sum;
            };
            const auto fastest = [&] {
                double v = 0;
                for (const auto& s : contacts)
                    for (int i : s) v = std::max(v, nodes.v[i].norm());
                return v;
            };
            const double energyBefore = energy(), fastestBefore = fastest();
            const auto v = nodes.v;
            strike<2>(c.problem, contacts, c.state);
            struck += v != nodes.v;
            EXPECT_LE(energy(), energyBefore * (1 + 1e-12));
            EXPECT_LE(fastest(), fastestBefore * (1 + 1e-12));
        }
        EXPECT_GT(struck, 400);
    }
}

}  // namespace
