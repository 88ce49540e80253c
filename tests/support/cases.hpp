#pragma once
// Small cases for tests, described in the words of the dictionaries.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "mesh/simplex.hpp"
#include "mesher/mesher.hpp"
#include "mesher/readMeshDict.hpp"
#include "solver/courantRate.hpp"
#include "solver/formerEntries.hpp"
#include "solver/simulation.hpp"

namespace pfem::test {

/// A simulation with what tests ask of it.
struct TestCase : Simulation<2> {
    const std::vector<PatchKind>& kinds() const { return problem.conditions.kind; }
    Topology<2> topology() const { return makeTopology<2>(state.mesh, kinds(), state.nodes.x, state.nodes.wall); }
    NodeConstraints<2> constraints(const Topology<2>& topology) const {
        return nodeConstraints<2>(state.mesh, problem.conditions, topology, state.nodes, state.time.value,
                                  state.time.value);
    }
    void tolerance(double value, int maxIterations = 200) {
        controls.convergence.tolU = controls.convergence.tolP = value;
        controls.convergence.maxIterations = maxIterations;
    }
    double ledgerSum() const { return state.ledger.sum(); }
};

/// From the text of system/meshDict, constant/materials and constant/boundaryConditions.
inline TestCase makeCase(const std::string& mesh, const std::string& materials, const std::string& conditions,
                         const Vec<2>& gravity = {0, -9.81}) {
    const auto all = readMaterials(Dictionary::parse(materials, "materials"));
    std::vector<std::string> names;
    for (const auto& m : all) names.push_back(m.name);
    TestCase c;
    c.state = buildMesh(readMeshDict(Dictionary::parse(mesh, "meshDict"), names)).state;
    for (const auto& name : c.state.mesh.materials) c.problem.materials.push_back(findMaterial(all, name));
    c.problem.gravity = gravity;
    c.problem.conditions =
        readBoundaryConditions<2>(Dictionary::parse(conditions, "boundaryConditions"), c.state.mesh.patches);
    return c;
}

/// Gives the solids of type hypoelastic the law of an update with the same E and nu: rotatedMidpoint (their own),
/// paper, neoHookean.
inline void useUpdate(Problem<2>& problem, const std::string& update) {
    applyStressUpdate<2>(Dictionary::parse("solid { stressUpdate " + update + "; }", "pfemSolution"), problem);
}

inline const std::string water = "water { type newtonian; rho 1000; mu 1e-3; kappa 2.1e9; }\n";
inline const std::string rubber = "rubber { type hypoelastic; rho 1500; E 2e5; nu 0.3; }\n";

/// (x0 y0) (x1 y0) (x1 y1) (x0 y1)
inline std::string rectangle(double x0, double y0, double x1, double y1) {
    const auto point = [](double x, double y) { return "(" + std::to_string(x) + " " + std::to_string(y) + ") "; };
    return "vertices (" + point(x0, y0) + point(x1, y0) + point(x1, y1) + point(x0, y1) + ");";
}

/// A tank of 1 m with 0.5 m of water, whose surface begins at a slope of -0.2; `tank`: the condition of its walls.
inline TestCase tiltedTank(const std::string& meshSize, const std::string& tank) {
    return makeCase("meshSize " + meshSize +
                        "; bodies ( water { type fluid; material water; vertices ((0 0) (1 0) (1 0.4) (0 0.6)); } );"
                        " walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                    water, "tank { " + tank + " }");
}

/// Fluid (below y = 0.5) on a solid of the unit square, 0.1 m cells, all nodes shifted at random: an irregular mesh
/// with an interface that is not straight. Distinct masses and stiffnesses, so that a swap is seen.
inline TestCase irregularPair() {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ("
        "lower { type fluid; material water; " +
            rectangle(0, 0, 1, 0.5) +
            " }"
            "upper { type solid; material rubber; " +
            rectangle(0, 0.5, 1, 1) + " patches { top { edges ((2 3)); } } } );",
        "water { type newtonian; rho 1000; mu 3; kappa 2.1e9; }" + rubber, "top { type clamped; }");
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.015, 0.015);
    for (auto& x : c.state.nodes.x) x += Vec<2>(shift(random), shift(random));
    c.state.nodes.X = c.state.nodes.x;
    return c;
}

inline Points<2> randomVectors(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    Points<2> v(n);
    for (auto& u : v) u = {value(random), value(random)};
    return v;
}

inline std::vector<double> randomNumbers(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    std::vector<double> v(n);
    for (double& u : v) u = value(random);
    return v;
}

inline double dot(const Points<2>& a, const Points<2>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

inline double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

inline double largest(const Points<2>& a) {
    double m = 0;
    for (const auto& u : a) m = std::max(m, u.norm());
    return m;
}

inline double largest(const std::vector<double>& a) {
    double m = 0;
    for (double u : a) m = std::max(m, std::abs(u));
    return m;
}

/// Node nearest to a point.
inline int nearestNode(const Points<2>& x, const Vec<2>& point) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(x.size()); ++i)
        if ((x[i] - point).squaredNorm() < (x[best] - point).squaredNorm()) best = i;
    return best;
}

/// Node with this id, -1 without.
inline int nodeOf(const Nodes<2>& nodes, Id id) {
    const auto it = std::lower_bound(nodes.id.begin(), nodes.id.end(), id);
    return it == nodes.id.end() || *it != id ? -1 : static_cast<int>(it - nodes.id.begin());
}

/// Least-squares fit y = c + a cos(w t) + b sin(w t); the frequency by golden section in [low, high].
struct Harmonic {
    double omega = 0, mean = 0, amplitude = 0, residual = 0;
};

inline Harmonic fitHarmonic(const std::vector<double>& t, const std::vector<double>& y, double low, double high) {
    const auto fit = [&](double w) {
        Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
        Eigen::Vector3d b = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < t.size(); ++i) {
            const Eigen::Vector3d row(1, std::cos(w * t[i]), std::sin(w * t[i]));
            A += row * row.transpose();
            b += row * y[i];
        }
        const Eigen::Vector3d c = A.inverse() * b;
        double residual = 0;
        for (std::size_t i = 0; i < t.size(); ++i) {
            const double r = y[i] - c.dot(Eigen::Vector3d(1, std::cos(w * t[i]), std::sin(w * t[i])));
            residual += r * r;
        }
        return Harmonic{w, c[0], std::hypot(c[1], c[2]), residual};
    };
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    while (high - low > 1e-8 * high) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (fit(a).residual < fit(b).residual ? high : low) = fit(a).residual < fit(b).residual ? b : a;
    }
    return fit(0.5 * (low + high));
}

/// Water beside and over a soft solid step in a tank.
inline TestCase waterBesideStep() {
    return makeCase(
        "meshSize 0.05; bodies ("
        " water { type fluid; material water; vertices ((0 0) (0.4 0) (0.4 0.2) (0.6 0.2) (0.6 0.4) (0 0.4)); }"
        " step { type solid; material soft; vertices ((0.4 0) (0.6 0) (0.6 0.2) (0.4 0.2));"
        "   patches { base { edges ((0 1)); } } } );"
        " walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
        "water { type newtonian; rho 1000; mu 0.5; kappa 2.1e9; }"
        "soft { type hypoelastic; rho 1200; E 1e5; nu 0.3; }",
        "tank { type slip; } base { type clamped; }");
}

}  // namespace pfem::test
