// Directions in which a node may move in space, and what it does in the others when walls move.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

void expectOrthonormal(const Freedom<3>& f) {
    EXPECT_LT((f.basis.transpose() * f.basis - Tensor<3>::Identity()).norm(), 1e-12);
}

// Holding normals one after the other leaves what is orthogonal to all of them, whatever their angles and lengths.
TEST(Freedom, leavesWhatIsOrthogonalToAllNormals) {
    const auto random = someVectors<3>(60, 4);
    for (int k = 0; k + 2 < 60; k += 3) {
        const Vec<3> a = 5 * random[k], b = 0.1 * random[k + 1];
        const Vec<3>& u = random[k + 2];
        const Freedom<3> plane = Freedom<3>().without(a), line = plane.without(b);
        ASSERT_EQ(plane.count, 2);
        ASSERT_EQ(line.count, 1);
        expectOrthonormal(plane);
        expectOrthonormal(line);
        EXPECT_LT((plane.project(u) - (u - a.normalized() * a.normalized().dot(u))).norm(), 1e-12);
        const Vec<3> along = a.cross(b).normalized();
        EXPECT_LT((line.project(u) - along * along.dot(u)).norm(), 1e-12);
        EXPECT_EQ(line.without(Vec<3>(0.7 * a - 3 * b)).count, 1);  // held already
        EXPECT_EQ(line.without(along).count, 0);
        EXPECT_EQ(line.without(along).project(u).norm(), 0);
    }
}

/// A corner of three planes whose angles are 60 to 120 degrees: `normal` out of the fluid, through the origin.
struct Corner {
    std::array<Vec<3>, 3> normal{Vec<3>(-1, 0.3, 0.2).normalized(), Vec<3>(0.4, -1, 0.1).normalized(),
                                 Vec<3>(0.2, 0.3, -1).normalized()};

    /// Directions of its edges, away from the corner: edge k lies in the planes k and k + 1.
    Vec<3> edge(int k) const {
        const Vec<3> e = normal[k].cross(normal[(k + 1) % 3]).normalized();
        return e.dot(normal[(k + 2) % 3]) < 0 ? e : Vec<3>(-e);
    }
};

/// Fluid in the corner: the tetrahedron of its three edges, and each of its planes a patch that moves by `motion`.
TestCase3 inACorner(const Corner& corner, const std::string& conditions) {
    TestCase3 c;
    State<3>& state = c.state;
    state.mesh.materials = {"water"};
    auto& nodes = state.nodes;
    nodes.resize(4);
    for (int k = 0; k < 3; ++k) nodes.x[k + 1] = corner.edge(k);
    nodes.x[0].setZero();
    Simplex<3> cell{0, 1, 2, 3};
    if (simplexMeasure<3>(nodes.x, cell) < 0) std::swap(cell[0], cell[1]);
    state.mesh.fluid.nodes = {cell};
    state.mesh.fluid.material = {0};
    for (int k = 0; k < 4; ++k) {
        nodes.id[k] = state.nextId++;
        nodes.h[k] = 1;
    }
    for (int k = 0; k < 3; ++k) {  // plane k holds the edges k - 1 and k
        Patch<3> patch{std::string(1, static_cast<char>('a' + k)), {}};
        const Vec<3> e = 3 * corner.edge((k + 2) % 3), f = 3 * corner.edge(k);
        addQuad(state, patch, {Vec<3>::Zero(), e, Vec<3>(e + f), f}, Vec<3>(e + f - corner.normal[k]));
        state.mesh.patches.push_back(patch);
    }
    nodes.X = nodes.x;
    c.problem.materials = readMaterials(Dictionary::parse(water, "materials"));
    c.problem.conditions = readBoundaryConditions<3>(Dictionary::parse(conditions, "conditions"), state.mesh.patches);
    separateFromWalls<3>({true, true, true}, state);
    return c;
}

// Two or three moving walls that are not perpendicular: what each demands of the velocity and the place of a node
// between them is met by all at once, n_k . v = n_k . v_k.
TEST(Following, nodesBetweenMovingWallsFollowAllOfThem) {
    const Corner corner;
    const TestCase3 c = inACorner(corner,
                                  "a { type slip; motion { velocity (1 2 -0.5); } }"
                                  "b { type slip; motion { velocity (-0.3 0.4 2); } }"
                                  "c { type slip; }");
    const std::array<Vec<3>, 3> velocity{Vec<3>(1, 2, -0.5), Vec<3>(-0.3, 0.4, 2), Vec<3>::Zero()};
    const auto topology = c.topology();
    const double dt = 0.01;
    const auto constraints = nodeConstraints<3>(c.state.mesh, c.problem.conditions, topology, c.state.nodes, 0, dt);
    for (int i = 0; i < 4; ++i) {
        const Vec<3> place = c.state.nodes.x[i];
        std::vector<int> walls;
        for (int k = 0; k < 3; ++k)
            if (std::abs(place.dot(corner.normal[k])) < 1e-9) walls.push_back(k);
        ASSERT_EQ(walls.size(), i == 0 ? 3u : 2u);
        EXPECT_EQ(constraints.freedom[i].count, 3 - static_cast<int>(walls.size()));
        const Vec<3> free(0.7, -0.2, 0.9), v = constraints.velocity(i, place, free),
                                           x = constraints.position(i, place, place + dt * free);
        for (const int k : walls) {
            EXPECT_NEAR(corner.normal[k].dot(v), corner.normal[k].dot(velocity[k]), 1e-12) << i << " " << k;
            EXPECT_NEAR(corner.normal[k].dot(x - place), dt * corner.normal[k].dot(velocity[k]), 1e-12)
                << i << " " << k;
        }
        if (walls.size() == 2) {  // along the edge it is free
            const Vec<3> along = corner.normal[walls[0]].cross(corner.normal[walls[1]]).normalized();
            EXPECT_NEAR(along.dot(v), along.dot(free), 1e-12);
        }
        EXPECT_LT((constraints.project(i, v) - constraints.project(i, free)).norm(), 1e-12);
    }
}

// A no-slip wall holds what is left with its own motion.
TEST(Following, stickingNodesTakeTheMotionOfTheWallThatHoldsThem) {
    const Corner corner;
    const TestCase3 c =
        inACorner(corner, "a { type noSlip; motion { velocity (1 2 -0.5); } } b { type slip; } c { type slip; }");
    const auto topology = c.topology();
    const auto constraints = nodeConstraints<3>(c.state.mesh, c.problem.conditions, topology, c.state.nodes, 0, 0.01);
    for (int i = 0; i < 4; ++i) {
        const Vec<3> place = c.state.nodes.x[i];
        if (std::abs(place.dot(corner.normal[0])) > 1e-9 || topology.freeSurface[i]) continue;
        EXPECT_EQ(constraints.freedom[i].count, 0);
        EXPECT_NEAR(corner.normal[0].dot(constraints.velocity(i, place, Vec<3>::Ones()) - Vec<3>(1, 2, -0.5)), 0,
                    1e-12);
    }
}

}  // namespace
