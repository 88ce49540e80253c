// Three dimensions: exact solutions, with remeshing in every step.

#include <gtest/gtest.h>

#include <cstdlib>

#include "mesher/space/readSpaceDict.hpp"
#include "mesher/space/spaceMesher.hpp"
#include "state/volume.hpp"
#include "support/cases3.hpp"
#include "walls/landing.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81;

double fastest(const TestCase3& c) {
    double most = 0;
    for (const auto& v : c.state.nodes.v) most = std::max(most, v.norm());
    return most;
}

/// Largest error of the pressure of water at rest with its level at `top`, in parts of rho g top.
double pressureError(const TestCase3& c, double top) {
    const auto topology = c.topology();
    double most = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i))
            most = std::max(most, std::abs(c.state.nodes.p[i] / (1000 * g) - (top - c.state.nodes.x[i][2])));
    return most / top;
}

TestCase3 tight(TestCase3 c) {
    c.controls.convergence.tolU = c.controls.convergence.tolP = 1e-10;
    c.controls.convergence.maxIterations = 200;
    return c;
}

TEST(Space, waterRestsInABox) {
    for (const char* type : {"slip", "noSlip"}) {
        TestCase3 c = tight(boxOfWater({0.4, 0.3, 0.2}, {0.4, 0.3, 0.4}, 0.05, type, 1e-3, 0.2));
        c.start(2e-3);
        const double volume = totalVolume<3>(c.state);
        for (int n = 0; n < 100; ++n) c.step(2e-3);
        EXPECT_LT(pressureError(c, 0.2), 1e-6) << type;
        EXPECT_LT(fastest(c), 1e-8) << type;
        EXPECT_NEAR(totalVolume<3>(c.state), volume, 1e-12);
    }
}

/// Water in a vertical cylinder of radius R, its walls through the fluid's own nodes on the rim.
TestCase3 cylinderOfWater(double R, double depth, double h) {
    TestCase3 c;
    State<3>& state = c.state;
    state.mesh.materials = {"water"};
    addLattice(state, state.mesh.fluid, 0, {-1, -1, 0}, {1, 1, depth / R}, h / R);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-0.15 * h, 0.15 * h);
    std::map<double, Vec<3>> rim;  // by angle, at the floor
    for (int i = 0; i < state.nodes.size(); ++i) {
        const Vec<3> q = state.nodes.x[i];
        const bool inside = std::abs(q[0]) < 1 - 1e-9 && std::abs(q[1]) < 1 - 1e-9;
        Vec<3>& x = state.nodes.x[i];
        x = R * Vec<3>(q[0] * std::sqrt(1 - 0.5 * q[1] * q[1]), q[1] * std::sqrt(1 - 0.5 * q[0] * q[0]), q[2]);
        state.nodes.h[i] = h;
        if (!inside && std::abs(q[2]) < 1e-9) rim[std::atan2(x[1], x[0])] = x;
        if (inside && q[2] > 1e-9 && q[2] < depth / R - 1e-9)
            for (int d = 0; d < 3; ++d) x[d] += shift(random);
    }
    state.nodes.X = state.nodes.x;
    Patch<3> tank{"tank", {}};
    const Vec<3> up(0, 0, 2 * depth), middle(0, 0, 0.5 * depth);
    std::vector<Vec<3>> ring;
    for (const auto& [angle, x] : rim) ring.push_back(x);
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec<3>&a = ring[k], &b = ring[(k + 1) % ring.size()];
        addQuad(state, tank, {a, b, b + up, a + up}, middle);
        Patch<3> floor = tank;
        addQuad(state, floor, {a, b, Vec<3>::Zero(), Vec<3>::Zero()}, middle);
        tank.faces.push_back(floor.faces[tank.faces.size()]);
    }
    state.mesh.patches.push_back(tank);
    c.problem.materials =
        readMaterials(Dictionary::parse("water { type newtonian; rho 1000; mu 1e-3; kappa 2.1e9; }", "materials"));
    c.problem.gravity = {0, 0, -g};
    c.problem.conditions =
        readBoundaryConditions<3>(Dictionary::parse("tank { type slip; }", "boundaryConditions"), state.mesh.patches);
    separateFromWalls<3>({true}, state);
    return c;
}

TEST(Space, waterRestsInACylinder) {
    TestCase3 c = tight(cylinderOfWater(0.2, 0.2, 0.06));
    c.start(2e-3);
    const double volume = totalVolume<3>(c.state);
    for (int n = 0; n < 100; ++n) c.step(2e-3);
    EXPECT_LT(pressureError(c, 0.2), 1e-6);
    EXPECT_LT(fastest(c), 1e-8);
    EXPECT_NEAR(totalVolume<3>(c.state), volume, 1e-12);
}

TEST(Space, freeFall) {
    TestCase3 c = tight(boxOfWater({0.3, 0.3, 0.3}, {9, 9, 9}, 0.1, "slip", 1e-3, 0.2));
    const auto wet = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        if (wet.wet(i)) c.state.nodes.x[i] += Vec<3>(1, 2, 5);
        c.state.nodes.X[i] = c.state.nodes.x[i];
        c.state.nodes.wall[i] = unsupported<3>();
    }
    c.start(1e-2);
    for (int n = 0; n < 20; ++n) c.step(1e-2);
    const auto topology = c.topology();
    double error = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i)) error = std::max(error, (c.state.nodes.v[i] - Vec<3>(0, 0, -g * 0.2)).norm());
    EXPECT_LT(error, 1e-10);
}

/// The axes of an ellipsoid of water in potential flow v = (A x, A y, -2 A z), free of gravity: with the axes a, a, c
/// and a^2 c = 1 the pressure is quadratic and zero at the surface; energy T = (4 pi/3) rho a^2 c (2 a'^2 + c'^2)/10 is
/// constant. Runge-Kutta in time.
std::pair<double, double> ellipsoid(double A, double time) {
    double a = 1, rate = A;                       // a'/a
    const auto slope = [](double a0, double r) {  // c = a^-2, c'/c = -2 r: T ~ (a r)^2 + 2 (r/a^2)^2 is constant
        const double a6 = std::pow(a0, -6);
        // d/dt of (a^2 r^2 + 2 r^2 a^-4) = 0:  r' = -r^2 (a^2 - 4 a^-4)/(a^2 + 2 a^-4)
        return std::pair(a0 * r, -r * r * (1 - 4 * a6) / (1 + 2 * a6));
    };
    const int steps = 20000;
    const double dt = time / steps;
    for (int n = 0; n < steps; ++n) {
        const auto [a1, r1] = slope(a, rate);
        const auto [a2, r2] = slope(a + 0.5 * dt * a1, rate + 0.5 * dt * r1);
        const auto [a3, r3] = slope(a + 0.5 * dt * a2, rate + 0.5 * dt * r2);
        const auto [a4, r4] = slope(a + dt * a3, rate + dt * r3);
        a += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        rate += dt / 6 * (r1 + 2 * r2 + 2 * r3 + r4);
    }
    return {a, 1 / (a * a)};
}

/// A ball of radius 1 of tetrahedra of size h that moves with (A x, A y, -2 A z).
TestCase3 ball(double h, double A) {
    TestCase3 c;
    State<3>& state = c.state;
    state.mesh.materials = {"water"};
    addLattice(state, state.mesh.fluid, 0, {-1, -1, -1}, {1, 1, 1}, h);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.1 * h, 0.1 * h);
    for (auto& x : state.nodes.x) {  // cube to ball
        const Vec<3> q = x, s = q.cwiseAbs2();
        const bool inside = q.cwiseAbs().maxCoeff() < 1 - 1e-9;
        for (int d = 0; d < 3; ++d) {
            const double u = s[(d + 1) % 3], w = s[(d + 2) % 3];
            x[d] = q[d] * std::sqrt(1 - 0.5 * u - 0.5 * w + u * w / 3);
        }
        for (int d = 0; inside && d < 3; ++d) x[d] += shift(random);
    }
    state.nodes.X = state.nodes.x;
    for (int i = 0; i < state.nodes.size(); ++i) {
        state.nodes.h[i] = h;
        state.nodes.v[i] = A * Vec<3>(state.nodes.x[i][0], state.nodes.x[i][1], -2 * state.nodes.x[i][2]);
    }
    c.problem.materials =
        readMaterials(Dictionary::parse("water { type newtonian; rho 1000; mu 0; kappa 2.1e12; }", "materials"));
    c.problem.conditions = readBoundaryConditions<3>(Dictionary::parse("", "boundaryConditions"), {});
    return c;
}

/// Second moments of the volume give the axes; `tolerance` of each when the longest has doubled.
void expectEllipsoid(TestCase3 c, double A, double dt, double tolerance, double volumeTolerance) {
    c.start(dt);
    const double volume = totalVolume<3>(c.state), radius = std::cbrt(volume / (4 * M_PI / 3));
    double axis = 1;
    int rejected = 0;
    while (axis < 2) {
        rejected += c.step(dt).rejected;
        const auto [a, b] = ellipsoid(A, c.state.time.value);
        axis = std::max(a, b);
    }
    const auto [a, b] = ellipsoid(A, c.state.time.value);
    Vec<3> squares = Vec<3>::Zero();  // of the volume: a_k^2/5
    for (const auto& cell : c.state.mesh.fluid.nodes) {
        const double measure = simplexMeasure<3>(c.state.nodes.x, cell);
        Vec<3> sum = Vec<3>::Zero(), own = Vec<3>::Zero();
        for (const int i : cell) sum += c.state.nodes.x[i], own += c.state.nodes.x[i].cwiseAbs2();
        squares += measure / 20 * (sum.cwiseAbs2() + own);
    }
    const double v = totalVolume<3>(c.state);
    const Vec<3> axes = (5 * squares / v).cwiseSqrt(), theory(a, a, b);
    const double scale = std::cbrt(axes[0] * axes[1] * axes[2]);
    std::cout << "A " << A << ", " << c.state.mesh.fluid.size() << " cells: axes " << axes.transpose() / scale
              << " theory " << theory.transpose() << ", volume " << v / volume - 1 << ", rejected " << rejected
              << ", radius " << radius << "\n";
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(axes[k] / scale, theory[k], tolerance * theory[k]);
    EXPECT_NEAR(v, volume, volumeTolerance * volume);
}

TEST(Space, ballBecomesAnEllipsoid) {
    for (const double A : {-100.0, 50.0}) expectEllipsoid(ball(0.25, A), A, 1e-4, 0.01, 1e-3);
}

/// The same with the mesh of a case (on lattices that are bent to a ball finer cells are inverted).
TEST(Space, meshedBallBecomesAnEllipsoid) {
    const bool fine = std::getenv("PFEM_LONG_TESTS") != nullptr;
    const double h = fine ? 0.1 : 0.25;
    const auto description = readSpaceDict(
        Dictionary::parse("dimension 3; bodies { ball { type fluid; material water; geometry { type sphere; centre (0 "
                          "0 0); radius 1; } } }",
                          "meshDict"),
        {"water"}, "", h);
    for (const double A : {-100.0, 50.0}) {
        TestCase3 c = ball(0.25, A);
        c.state = buildSpaceMesh(description).state;
        auto& nodes = c.state.nodes;
        for (int i = 0; i < nodes.size(); ++i)
            nodes.v[i] = A * Vec<3>(nodes.x[i][0], nodes.x[i][1], -2 * nodes.x[i][2]);
        expectEllipsoid(c, A, 1e-4, fine ? 5e-3 : 0.015, fine ? 5e-4 : 1e-3);
    }
}

/// Amplitude of cos(k x) cos(l y) of the surface's height, from its faces.
double modeOf(const TestCase3& c, const Vec<2>& k, double level) {
    const auto topology = c.topology();
    double sum = 0;
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double flat = faceArea<3>(c.state.nodes.x, face.nodes)[2];
        for (const int i : face.nodes) {
            const Vec<3>& x = c.state.nodes.x[i];
            sum += flat / 3 * (x[2] - level) * std::cos(k[0] * x[0]) * std::cos(k[1] * x[1]);
        }
    }
    return sum;
}

/// Zero crossings of a signal from its maximum at t = 0: the period, from the last of them.
double periodOf(const std::vector<double>& t, const std::vector<double>& y) {
    double mean = 0, last = 0;
    for (const double v : y) mean += v / static_cast<double>(y.size());
    int crossings = 0;
    for (std::size_t n = 1; n < y.size(); ++n)
        if ((y[n] - mean) * (y[n - 1] - mean) < 0) {
            last = t[n - 1] + (t[n] - t[n - 1]) * (y[n - 1] - mean) / (y[n - 1] - y[n]);
            ++crossings;
        }
    return last / (0.25 + 0.5 * (crossings - 1));
}

/// Modes (1,0) and (1,1) of a box 1 x 0.6 m, 0.5 m deep: omega^2 = g k tanh(k H). With h = 0.1 m these are 20 and 10
/// cells a wave. What the period is too long by, in parts of it.
double expectBoxSloshes(const std::string& mass, int m, double tolerance, double h = 0.1) {
    const double L = 1, B = 0.6, H = 0.5, amplitude = 0.01, dt = 0.01;
    const Vec<2> k(M_PI / L, m * M_PI / B);
    TestCase3 c = boxOfWater({L, B, H}, {L, B, 0.8}, h, "slip", 1e-3, 0.1);
    c.controls.momentum.mass = mass;
    for (auto& x : c.state.nodes.x)
        if (x[2] < H + 1e-9) x[2] += x[2] / H * amplitude * std::cos(k[0] * x[0]) * std::cos(k[1] * x[1]);
    c.start(dt);
    const double omega = std::sqrt(g * k.norm() * std::tanh(k.norm() * H)), volume = totalVolume<3>(c.state);
    std::vector<double> t{0}, y{modeOf(c, k, H)};
    while (c.state.time.value < 2.3 * 2 * M_PI / omega) {
        c.step(dt);
        t.push_back(c.state.time.value);
        y.push_back(modeOf(c, k, H));
    }
    const double ratio = periodOf(t, y) * omega / (2 * M_PI);
    std::cout << mass << " mass, mode (1," << m << "), h " << h << " m: period " << ratio << " of theory, volume "
              << totalVolume<3>(c.state) / volume - 1 << "\n";
    EXPECT_NEAR(ratio, 1, tolerance) << m;
    EXPECT_NEAR(totalVolume<3>(c.state), volume, 5e-4 * volume);
    return ratio - 1;
}

TEST(Space, boxSloshes) {
    const double fine = expectBoxSloshes("lumped", 0, 0.01), coarse = expectBoxSloshes("lumped", 0, 0.06, 0.2);
    EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse));
    expectBoxSloshes("lumped", 1, 0.06);
}
TEST(Space, boxSloshesWithConsistentMass) { expectBoxSloshes("consistent", 1, 0.006); }

// What crosses two walls within a step, by their common edge, lands on both; into a corner, on three. One that slides
// on the floor and crosses the sides stays in the corner, or before it when somebody is there.
TEST(Space, nothingLeavesATankByAnEdge) {
    TestCase3 c = boxOfWater({0.3, 0.3, 0.3}, {1, 1, 1}, 0.1);
    auto& nodes = c.state.nodes;
    const auto put = [&](const Vec<3>& x, const Supports<3>& wall) {
        nodes.resize(nodes.size() + 1);
        nodes.id.back() = c.state.nextId++;
        nodes.x.back() = nodes.X.back() = x;
        nodes.h.back() = 0.1;
        nodes.dropVolume.back() = 1e-6;
        nodes.wall.back() = wall;
        return nodes.size() - 1;
    };
    const auto wallAt = [&](const Vec<3>& x) {
        Supports<3> supports = unsupported<3>();
        const auto faces = c.topology().walls;
        for (int w = 0; w < static_cast<int>(faces.size()) && supports[0] < 0; ++w) {
            const auto place = placeOnRegion<3>(faces, nodes.x, w, x);
            if ((place.x - x).norm() < 1e-9) supports[0] = place.face;
        }
        return supports;
    };
    const int edge = put({0.96, 0.96, 0.5}, unsupported<3>()), corner = put({0.97, 0.96, 0.04}, unsupported<3>()),
              slides = put({0.95, 0.5, 0}, wallAt({0.95, 0.5, 0})),
              late = put({0.93, 0.94, 0}, wallAt({0.93, 0.94, 0}));
    const auto topology = c.topology();
    const Points<3> old = nodes.x;
    const auto move = [&](int i, const Vec<3>& way) {
        nodes.x[i] += way;
        nodes.v[i] = way / 0.01;
    };
    move(edge, {0.08, 0.07, 0});
    move(corner, {0.07, 0.08, -0.09});
    move(slides, {0.1, 0.01, 0});
    move(late, {0.1, 0.12, 0});
    landOnWalls<3>(c.controls.remeshing.expert.walls, topology, old, g, c.state);
    for (const int i : {edge, corner, slides, late}) {
        EXPECT_LE(nodes.x[i].maxCoeff(), 1 + 1e-9) << nodes.x[i].transpose();
        EXPECT_GE(nodes.x[i].minCoeff(), -1e-9) << nodes.x[i].transpose();
    }
    EXPECT_EQ(nSupports(nodes.wall[edge]), 2);
    EXPECT_EQ(nSupports(nodes.wall[slides]), 2);
    EXPECT_EQ(nSupports(nodes.wall[corner]) + nSupports(nodes.wall[late]), 5);  // one has the corner
    EXPECT_LT((nodes.v[edge] - Vec<3>(0, 0, 0)).norm(), 1e-9);
    EXPECT_LT((nodes.v[slides] - Vec<3>(0, 1, 0)).norm(), 1e-9);
}

}  // namespace
