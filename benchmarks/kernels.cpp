// What one call of each part of a step costs, on the water column of tutorials/damBreakRigidWall with about N
// triangles.
//
//     benchmarkKernels --benchmark_filter=Pressure

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>

#include "continuity/continuitySystem.hpp"
#include "continuity/residual.hpp"
#include "continuity/stabilisation.hpp"
#include "io/stateFiles.hpp"
#include "linear/dissectedLdlt.hpp"
#include "linear/ldlt.hpp"
#include "linear/oracles.hpp"
#include "momentum/fluidStress.hpp"
#include "momentum/mass.hpp"
#include "remesh/delaunay.hpp"
#include "remesh/remesh.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// The column at rest, a tenth of a second after its gate has gone: surfaces, walls and velocities as in a run.
const TestCase& column(int triangles) {
    static std::map<int, TestCase> known;
    const auto found = known.find(triangles);
    if (found != known.end()) return found->second;
    const double h = std::sqrt(4 * 0.18 / (std::sqrt(3.0) * triangles));
    TestCase c =
        makeCase("meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " +
                     rectangle(0, 0, 0.6, 0.3) + " } ); walls ( tank { points ((0 1) (0 0) (1.61 0) (1.61 1)); } );",
                 water, "tank { type slip; }");
    c.start(1e-4);
    for (int k = 0; k < 20; ++k) c.step(0.05 * h);
    return known.emplace(triangles, std::move(c)).first->second;
}

/// What a step has at its start.
struct StartOfStep {
    const TestCase& c;
    Topology<2> topology = c.topology();
    NodeConstraints<2> constraints = c.constraints(topology);
    const Nodes<2>& nodes = c.state.nodes;
    const Cells<2>& cells = c.state.mesh.fluid;
    double dt = 0.1 * nodes.h[0];
    FluidPhase<2> phase{c.problem, c.state.mesh, topology.fluid, nodes, Integration::nodal};
    SmoothingDomains<2>& fluid = phase.domains;
    Stabilisation tau{stabilisation<2>(c.problem, cells, fluid, phase.mu, nodes.v, dt),
                      projectedCells<2>(c.controls.continuity, c.problem, cells, topology, nodes)};
    SolidBlock<2> noSolid{solidDofs<2>(topology.solid, constraints), symmetricPattern({})};
    Step<2> step{c.problem, c.state.mesh, topology, constraints, nodes, {dt}};
    Trial<2> trial = firstTrial<2>(step);

    ContinuitySystem<2> system() const { return {step, c.controls.continuity, phase, tau, nodes.x, noSolid}; }
};

void perTriangle(benchmark::State& state, const TestCase& c) {
    state.counters["triangles"] = c.state.mesh.fluid.size();
    state.counters["time/triangle"] =
        benchmark::Counter(static_cast<double>(c.state.mesh.fluid.size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void triangulation(benchmark::State& state) {
    const TestCase& c = column(static_cast<int>(state.range(0)));
    std::vector<int> active(c.state.nodes.size());
    for (int i = 0; i < c.state.nodes.size(); ++i) active[i] = i;
    for (auto _ : state) benchmark::DoNotOptimize(constrainedDelaunay(c.state.nodes.x, active, {}, {}));
    perTriangle(state, c);
}

void remeshing(benchmark::State& state) {
    const TestCase& c = column(static_cast<int>(state.range(0)));
    Triangulator<2> triangulator;
    for (auto _ : state) {
        state.PauseTiming();
        State<2> copy = c.state;
        Topology<2> topology = c.topology();
        state.ResumeTiming();
        benchmark::DoNotOptimize(
            remesh<2>({c.controls.remeshing, c.kinds(), std::move(topology), 1e-4}, triangulator, copy));
    }
    perTriangle(state, c);
}

void topologyOfStep(benchmark::State& state) {
    const TestCase& c = column(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(c.topology());
    perTriangle(state, c);
}

void patchesOfNodes(benchmark::State& state) {
    StartOfStep s{column(static_cast<int>(state.range(0)))};
    for (auto _ : state) updateSmoothingDomains<2>(s.fluid, s.nodes.x);
    perTriangle(state, s.c);
}

void viscousOperator(benchmark::State& state) {
    const StartOfStep s{column(static_cast<int>(state.range(0)))};
    const PerPoint<double> mu(s.nodes.size(), 1e-3);
    for (auto _ : state)
        benchmark::DoNotOptimize(viscousForce<2>(s.fluid, mu, velocityGradients<2>(s.fluid, s.nodes.v)));
    perTriangle(state, s.c);
}

void continuityResidual(benchmark::State& state) {
    const StartOfStep s{column(static_cast<int>(state.range(0)))};
    for (auto _ : state)
        benchmark::DoNotOptimize(continuityResidual<2>(s.step, s.c.controls.continuity, s.phase, s.tau, s.trial));
    perTriangle(state, s.c);
}

void pressureMatrix(benchmark::State& state) {  // assembly, ordering, factor
    const StartOfStep s{column(static_cast<int>(state.range(0)))};
    for (auto _ : state) benchmark::DoNotOptimize(s.system());
    perTriangle(state, s.c);
}

void pressureSolution(benchmark::State& state) {
    const StartOfStep s{column(static_cast<int>(state.range(0)))};
    const auto system = s.system();
    const std::vector<double> residual(s.nodes.size(), 1e-6);
    for (auto _ : state) benchmark::DoNotOptimize(system.solve(residual));
    perTriangle(state, s.c);
}

/// The graph's Laplacian and a little mass on the column's nodes: the pattern of the pressure matrix, positive
/// definite.
SymmetricMatrix laplacian(const Topology<2>& topology) {
    std::vector<std::vector<int>> lower(topology.nNodes());
    for (int j = 0; j < topology.nNodes(); ++j)
        for (int s = topology.ring.start[j]; s < topology.ring.start[j + 1]; ++s)
            if (topology.ring.node[s] > j) lower[j].push_back(topology.ring.node[s]);
    for (auto& rows : lower) std::sort(rows.begin(), rows.end());
    SymmetricMatrix A = symmetricPattern(lower);
    for (int j = 0; j < A.n; ++j) {
        A.add(j, j, 1e-2);
        for (const int i : lower[j]) {
            A.add(i, i, 1);
            A.add(j, j, 1);
            A.add(i, j, -1);
        }
    }
    return A;
}

std::unique_ptr<SymmetricSolver> makeSolver(int which, const Points<2>& x) {
    if (which == 0) return std::make_unique<DissectedLdlt<2, float>>(x, slabs<2>(x, 2, 0), 2);
    if (which == 1) return std::make_unique<DissectedLdlt<2, double>>(x, slabs<2>(x, 2, 0), 2);
    if (which == 2) return std::make_unique<Ldlt>();
    if (which == 3) return std::make_unique<Cholmod>();
#ifdef PFEM_MUMPS
    return std::make_unique<Mumps>();
#else
    return nullptr;
#endif
}

/// Order, factor and one solution of a matrix with the pressure's pattern, by each solver behind the one interface.
void directSolver(benchmark::State& state) {
    const TestCase& c = column(static_cast<int>(state.range(0)));
    const SymmetricMatrix A = laplacian(c.topology());
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.n);
    const auto solver = makeSolver(static_cast<int>(state.range(1)), c.state.nodes.x);
    if (!solver) return state.SkipWithError("MUMPS is not installed");
    state.SetLabel(std::array{"dissected, float", "dissected, double", "Ldlt", "CHOLMOD", "MUMPS"}[state.range(1)]);
    for (auto _ : state) {
        solver->analyse(A);
        solver->factor(A);
        benchmark::DoNotOptimize(solver->solve(b));
    }
    perTriangle(state, c);
}

void writingOfState(benchmark::State& state) {
    const TestCase& c = column(static_cast<int>(state.range(0)));
    const auto folder = std::filesystem::temp_directory_path() / "pfemBenchmark" / "1";
    std::filesystem::create_directories(folder.parent_path());
    for (auto _ : state) writeState<2>(folder, c.state);
    std::filesystem::remove_all(folder.parent_path());
    perTriangle(state, c);
}

void wholeStep(benchmark::State& state) {
    const TestCase& start = column(static_cast<int>(state.range(0)));
    TestCase c = start;
    for (auto _ : state) c.step(0.1 * c.state.nodes.h[0]);
    perTriangle(state, c);
}

#define PFEM_SIZES \
    Unit(benchmark::kMillisecond)->Arg(6000)->Arg(24000)->Arg(96000)->MeasureProcessCPUTime()->UseRealTime()
BENCHMARK(triangulation)->PFEM_SIZES;
BENCHMARK(remeshing)->PFEM_SIZES;
BENCHMARK(topologyOfStep)->PFEM_SIZES;
BENCHMARK(patchesOfNodes)->PFEM_SIZES;
BENCHMARK(viscousOperator)->PFEM_SIZES;
BENCHMARK(continuityResidual)->PFEM_SIZES;
BENCHMARK(pressureMatrix)->PFEM_SIZES;
BENCHMARK(pressureSolution)->PFEM_SIZES;
BENCHMARK(directSolver)
    ->Unit(benchmark::kMillisecond)
    ->ArgsProduct({{6000, 24000, 96000}, {0, 1, 2, 3, 4}})
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(writingOfState)->PFEM_SIZES;
BENCHMARK(wholeStep)->PFEM_SIZES->Iterations(20);

}  // namespace

BENCHMARK_MAIN();
