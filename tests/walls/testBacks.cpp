// Water behind a wall keeps off its back.

#include "walls/backs.hpp"

#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double h = 0.1;

/// A column of water in the middle of an open tank 1 m wide and 0.6 m high; in space 0.6 m deep.
template <int Dim>
CaseOf<Dim> tank() {
    if constexpr (Dim == 2)
        return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0.3, 0, 0.7, 0.4) +
                            " } ); walls ( tank { points ((0 0.6) (0 0) (1 0) (1 0.6)); } );",
                        water, "tank { type slip; }");
    else
        return boxOfWater({0.4, 0.6, 0.4}, {1, 0.6, 0.6}, h);
}

/// A node of the water that no wall holds, in the place (x, z) and with the velocity (u, w).
template <int Dim>
struct Stray {
    CaseOf<Dim> c = tank<Dim>();
    int node = -1;

    Stray(double x, double z, double u, double w) {
        const auto topology = c.topology();
        for (int i = 0; node < 0; ++i)
            if (topology.ofFluid(i) && !isSupported(c.state.nodes.wall[i])) node = i;
        c.state.nodes.x[node] = at(x, z);
        c.state.nodes.v[node] = at(u, w);
        if (Dim == 3) c.state.nodes.x[node][1] = 0.32;
    }
    static Vec<Dim> at(double x, double z) {
        Vec<Dim> point = Vec<Dim>::Zero();
        point[0] = x;
        point[Dim - 1] = z;
        return point;
    }
    const Vec<Dim>& keepOff() {
        keepOffBacks<Dim>(c.topology(), c.state.nodes);
        return c.state.nodes.x[node];
    }
    const Vec<Dim>& v() const { return c.state.nodes.v[node]; }
};

PFEM_BOTH_DIMENSIONS(Backs);

// Behind the left wall, which the node approaches: 0.25 h in a step, to 0.7 h; what goes along the wall stays.
TYPED_TEST(Backs, nodesGoOff) {
    constexpr int Dim = TypeParam::value;
    Stray<Dim> stray(-0.1 * h, 0.2, 1, -2);
    EXPECT_NEAR(stray.keepOff()[0], -0.35 * h, 1e-12);
    EXPECT_NEAR(stray.v()[0], 0, 1e-12);
    EXPECT_NEAR(stray.v()[Dim - 1], -2, 1e-12);
    EXPECT_NEAR(stray.keepOff()[0], -0.6 * h, 1e-12);
    EXPECT_NEAR(stray.keepOff()[0], -0.7 * h, 1e-12);
    EXPECT_NEAR(stray.keepOff()[0], -0.7 * h, 1e-12);
    EXPECT_NEAR(stray.c.state.nodes.x[stray.node][Dim - 1], 0.2, 1e-12);
}

TYPED_TEST(Backs, othersStay) {
    constexpr int Dim = TypeParam::value;
    const auto stays = [](double x, double z) {
        Stray<Dim> stray(x, z, 1, 0);
        const Vec<Dim> before = stray.c.state.nodes.x[stray.node];
        return (stray.keepOff() - before).norm() == 0 && stray.v()[0] == 1;
    };
    EXPECT_TRUE(stays(0.1 * h, 0.2)) << "before the wall";
    EXPECT_TRUE(stays(-0.1 * h, 0.65)) << "over its rim";
    EXPECT_TRUE(stays(-0.1 * h, 0.6 - 0.9 * h)) << "beside its rim: 0.9 h and as much back";
    EXPECT_FALSE(stays(-0.1 * h, 0.6 - 1.2 * h));
    EXPECT_TRUE(stays(-0.8 * h, 0.2)) << "far enough";
}

}  // namespace
