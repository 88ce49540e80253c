// What outlets with a level press back: hydrostatic pressure, and the waves that go out over it.

#include "momentum/outletPressure.hpp"

#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

PFEM_BOTH_DIMENSIONS(OutletPressure);

constexpr double rho = 1000, g = 9.81, level = 0.9, waveSpeed = 2;

/// A box of water all of whose walls are outlets: each direction has one.
template <int Dim>
CaseOf<Dim> openPool() {
    const std::string outlet = "tank { type outlet; level 0.9; waveSpeed 2; }";
    if constexpr (Dim == 2) {
        return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.6, 0.4) +
                            " } ); walls ( tank { points ((0 0.8) (0 0) (0.6 0) (0.6 0.8)); } );",
                        water, outlet);
    } else {
        TestCase3 c = boxOfWater({0.5, 0.3, 0.4}, {0.5, 0.3, 0.8}, 0.1, "slip", 1e-3, 0.2);
        setConditions(c, outlet);
        return c;
    }
}

// Of the matrix: - d(force)/dv of a flow that is the same everywhere, lumped.
TYPED_TEST(OutletPressure, stiffnessIsItsDerivative) {
    constexpr int Dim = TypeParam::value;
    const CaseOf<Dim> c = openPool<Dim>();
    const auto topology = c.topology();
    const int n = c.state.nodes.size();
    const Vec<Dim> w = Vec<3>(0.7, -0.4, 0.5).head<Dim>();
    const auto force = [&](double factor) {
        Nodes<Dim> nodes = c.state.nodes;
        nodes.v.assign(n, factor * w);
        Points<Dim> f(n, Vec<Dim>::Zero());
        addOutletPressure<Dim>(c.problem, c.state.mesh.fluid, topology, nodes, f);
        return f;
    };
    Points<Dim> stiffness(n, Vec<Dim>::Zero());
    addOutletStiffness<Dim>(c.problem, c.state.mesh.fluid, topology, c.state.nodes.x, stiffness);
    const double eps = 1e-3;
    const auto plus = force(eps), minus = force(-eps);
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int i = 0; i < n; ++i) {
        EXPECT_LT(((plus[i] - minus[i]) / (2 * eps) + stiffness[i].cwiseProduct(w)).norm(), 1e-8) << i;
        sum += stiffness[i];
    }
    // rho c times what each direction sees of the outlets
    const Vec<Dim> area = Dim == 2 ? Vec<Dim>(Vec<3>(0.8, 0.6, 0).head<Dim>())
                                   : Vec<Dim>(Vec<3>(2 * 0.3 * 0.4, 2 * 0.5 * 0.4, 0.5 * 0.3).head<Dim>());
    EXPECT_LT((sum - rho * waveSpeed * area).norm(), 1e-9 * rho);
}

// Still water outside presses with rho g (level - z) on all walls; force and moment are those of the integrals.
TYPED_TEST(OutletPressure, stillWaterOutsideIsHydrostatic) {
    constexpr int Dim = TypeParam::value;
    const CaseOf<Dim> c = openPool<Dim>();
    Points<Dim> force(c.state.nodes.size(), Vec<Dim>::Zero());
    addOutletPressure<Dim>(c.problem, c.state.mesh.fluid, c.topology(), c.state.nodes, force);
    Vec<Dim> sum = Vec<Dim>::Zero();
    double pressing = 0, moment = 0;  // of the wall x = 0 alone
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        sum += force[i];
        if (std::abs(c.state.nodes.x[i][0]) > 1e-9) continue;
        pressing += force[i][0];
        moment += force[i][0] * c.state.nodes.x[i][Dim - 1];
    }
    const double floor = Dim == 2 ? 0.6 : 0.15, width = Dim == 2 ? 1 : 0.3, H = 0.4;
    EXPECT_LT((sum - rho * g * level * floor * Vec<Dim>::Unit(Dim - 1)).norm(), 1e-9 * rho);
    EXPECT_NEAR(pressing, rho * g * width * (level * H - H * H / 2), 1e-9 * rho);
    EXPECT_NEAR(moment, rho * g * width * (level * H * H / 2 - H * H * H / 3), 1e-9 * rho);
}

}  // namespace
