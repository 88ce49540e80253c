// The solver: free-surface fluids, elastic solids and both together, from the latest (or chosen) time folder on.

#include <chrono>
#include <ctime>
#include <iostream>
#include <optional>

#include "application/dimension.hpp"
#include "application/runApplication.hpp"
#include "application/together.hpp"
#include "case/interrupt.hpp"
#include "case/runLock.hpp"
#include "case/settings.hpp"
#include "case/timeControl.hpp"
#include "case/unfinished.hpp"
#include "conditions/inflow.hpp"
#include "functions/functionObjects.hpp"
#include "io/stateFiles.hpp"
#include "solver/checkProblem.hpp"
#include "solver/log.hpp"
#include "solver/recorder.hpp"
#include "solver/setup.hpp"
#include "solver/sharedPlaces.hpp"
#include "solver/sharedRun.hpp"
#include "solver/waveRate.hpp"
#include "walls/skins.hpp"

using namespace pfem;

namespace {

double clockNow() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double cpuNow() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What the last run has left: an old lock, unfinished folders, other settings. Returns those of now.
Settings welcome(const Case& theCase, const RunLock& lock) {
    if (!lock.abandoned().empty())
        std::cerr << "--> PFEM Warning : the lock of a run that did not end properly is taken over ("
                  << lock.abandoned() << ")\n";
    for (const auto& done : clearUnfinished(theCase.root())) std::cerr << "--> PFEM Warning : " << done << "\n";
    Settings settings = currentSettings(theCase);
    const std::string changes = settingChanges(theCase, settings);
    if (!changes.empty()) std::cout << "Settings that differ from those of the last run:\n" << changes << "\n";
    return settings;
}

/// The state of the start folder with what the dictionaries say of it.
template <int Dim>
Simulation<Dim> readSimulation(const Case& theCase, const TimeControl& clock) {
    Simulation<Dim> simulation;
    simulation.state = readState<Dim>(clock.startFolder());
    checkState<Dim>(clock.startFolder(), simulation.state);
    simulation.problem = readProblem<Dim>(theCase, simulation.state);
    separateFromSkins<Dim>(simulation.problem.conditions.kind, simulation.state);
    if (simulation.state.time.index == 0)
        std::cout << sharedPlacesText<Dim>(simulation.problem.conditions, simulation.problem.contact.on,
                                           simulation.state);
    simulation.controls = readControls(theCase);
    checkLaws<Dim>(simulation.problem, simulation.state.mesh, simulation.controls.solidScheme());
    simulation.nextTime = [&clock](const TimeInfo& time, double dt) { return clock.advance(time, dt); };
    return simulation;
}

/// The function objects of controlDict.
template <int Dim>
FunctionObjects<Dim> readFunctions(const Case& theCase, const TimeControl& clock, const TimeInfo& time) {
    const auto resumeAt = time.index > 0 ? std::optional(time.value) : std::nullopt;
    FunctionObjects<Dim> functions(theCase, clock.dictionary(), clock.startName(), clock.controls().writePrecision, {},
                                   resumeAt);
    warnUnused(clock.dictionary(), std::cerr);
    return functions;
}

/// The volume at the beginning of the case.
template <int Dim>
double firstVolume(const State<Dim>& state) {
    double volume = totalVolume<Dim>(state);
    for (const auto& [cause, amount] : state.ledger.byName()) volume -= amount;
    return volume;
}

/// The loop over time.
template <int Dim>
void advance(const Ranks& ranks, TimeControl& clock, Simulation<Dim>& simulation, Recorder<Dim>& recorder,
             FunctionObjects<Dim>& functions) {
    State<Dim>& state = simulation.state;
    const double volume = firstVolume<Dim>(state), elasticRate = elasticWaveRate<Dim>(simulation.problem, state);
    const double clockStart = clockNow(), timeStart = state.time.value;
    RunSummary summary;
    while (ranks.ofFirst(clock.running(state.time))) {
        const CourantRate rate = courantRate<Dim>(state);
        const double coming =
            inletRate<Dim>(simulation.problem.conditions, simulation.problem.period, state, state.time.value);
        const double dt = clock.deltaT(state.time, {.courant = std::max(rate.largest, coming),
                                                    .relative = rate.relative,
                                                    .compression = rate.compression,
                                                    .gravityWave = gravityWaveRate<Dim>(simulation.problem, state),
                                                    .elasticWave = elasticRate});
        const AdvanceReport report = recorder.step(ranks.ofFirst(dt));
        agree<Dim>(ranks, state);
        summary.add(report, state.mesh.fluid.size() + state.mesh.solid.size());
        std::cout << courantLines(rate, report.dt) << "Time = " << clock.name(state.time) << "\n\n"
                  << stepLines<Dim>(report, state, volume);

        const bool write = clock.writeDue(state.time);  // looks at controlDict first
        functions.execute(state, [&](int n) { return clock.folderDue(state.time, n); });
        state.memory = functions.memory();
        if (write) {
            recorder.save();
            if (state.ledger.counting()) state.ledger.countFields(state.nodes.size());
        }
        const double done = (state.time.value - timeStart) / (clock.controls().endTime - timeStart);
        std::cout << timeLines(cpuNow(), clockNow() - clockStart, done) << std::flush;
    }
    std::cout << summary.text(clockNow() - clockStart, Dim);
}

/// From the start folder to the end: the first rank reads and writes, the others compute with it.
template <int Dim>
int solve(const Ranks& ranks, const Case& theCase, const Settings& settings, TimeControl& clock) {
    Simulation<Dim> simulation = readSimulation<Dim>(theCase, clock);
    shareAmong<Dim>(ranks, simulation);
    ranks.wait();  // all have read
    if (!ranks.isFirst()) {
        followFirst<Dim>(ranks, simulation);
        return 0;
    }
    State<Dim>& state = simulation.state;
    FunctionObjects<Dim> functions = readFunctions<Dim>(theCase, clock, state.time);
    keepSettings(theCase, settings);  // all of them have been accepted

    if (functions.wantAppeared()) state.ledger.countFields(state.nodes.size());
    Recorder<Dim> recorder(theCase, clock, simulation);
    if (state.time.index == 0) recorder.start(ranks.ofFirst(clock.deltaT(state.time)));
    functions.start(state);
    if (clock.ended(state.time)) {
        recorder.list();
        std::cerr << "--> PFEM Warning: nothing to do: endTime is not after the start at " << state.time.value
                  << " s\n";
    }
    std::cout << "Starting time loop\n\n" << std::flush;
    advance<Dim>(ranks, clock, simulation, recorder, functions);

    if (const int signal = interrupted(); signal != 0) {
        std::cout << "Stopped by " << signalName(signal) << ", the state is written in the folder "
                  << clock.name(state.time) << ": start again to go on\n\n";
        return 128 + signal;
    }
    std::cout << "End\n\n";
    return 0;
}

int run(const Options& options, const Ranks& ranks) {
    const Case theCase = options.openCase();
    std::cout << startBanner(options, theCase, ranks.size()) << "Create time\n\n" << std::flush;
    std::optional<RunLock> lock;
    Settings settings;
    if (ranks.isFirst()) settings = welcome(theCase, lock.emplace(theCase.root(), options.program()));
    ranks.wait();  // what the last run has left is cleared
    TimeControl clock(theCase);
    std::cout << "Create mesh for time = " << clock.startName() << "\n\n" << std::flush;
    return withDimension(clock.startFolder(),
                         [&](auto dim) { return solve<decltype(dim)::value>(ranks, theCase, settings, clock); });
}

}  // namespace

int main(int argc, char* argv[]) {
    return runApplication(argc, argv,
                          "Solve free-surface flow and elastic solids in one system (nodal PFEM), from the time "
                          "folder that system/controlDict names.",
                          parallelOption(), [](const Options& options) {
                              return together(options, [&](const Ranks& ranks) { return run(options, ranks); });
                          });
}
