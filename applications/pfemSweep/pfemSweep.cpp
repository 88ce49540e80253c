// A study: system/sweepDict changes entries of the case, each combination is a case of its own, all run, one table.

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "application/optionValues.hpp"
#include "application/runApplication.hpp"
#include "base/atomicFile.hpp"
#include "case/interrupt.hpp"
#include "case/runLock.hpp"
#include "study/draw.hpp"
#include "study/jobs.hpp"
#include "study/runProgram.hpp"
#include "study/sweepPlot.hpp"

using namespace pfem;
namespace fs = std::filesystem;

namespace {

OptionsSpec sweepOptions() {
    OptionsSpec spec;
    spec.add("jobs", "n", "Cases at the same time (default: cores / processors; with -submit no limit)");
    spec.add("submit", "", "Leave the runs to Slurm, as a job array; gather later with -noRun");
    spec.add("noRun", "", "Read what is there into the table, run nothing");
    spec.add("overwrite", "", "Remove the study's cases and run them again");
    spec.add("folder", "name", "Where the cases and the table are (default 'sweep')");
    return spec.add("run", "number", "Run this one case as it was made; jobs do so");
}

/// The commands of sweepDict find the programs that stand beside this one, and use the cores that they may.
StudyCommands commandsOf(const Sweep& sweep) {
    const fs::path programs = fs::path(siblingProgram("pfemSweep")).parent_path();
    const char* path = std::getenv("PATH");
    if (!programs.empty()) setenv("PATH", (programs.string() + ":" + (path ? path : "")).c_str(), 1);
    setenv("OMP_NUM_THREADS", std::to_string(sweep.processors).c_str(), 1);
    return {.mesh = shellCommand(sweep.mesh), .solve = shellCommand(sweep.command), .tick = [] {
                if (jobMustStop() && !interrupted()) raise(SIGTERM);
            }};
}

Jobs jobsOf(const Options& options, const Case& theCase, const Sweep& sweep, const fs::path& folder) {
    Jobs jobs{siblingProgram("pfemSweep"), theCase.root(), folder, {}, 0, sweep.processors, sweep.slurm};
    const int cores = static_cast<int>(std::thread::hardware_concurrency()),
              most = options.found("submit") ? 0 : std::max(1, cores / sweep.processors);
    jobs.atOnce = options.found("jobs") ? wholeNumber(options, "jobs", most, 1, 100000) : most;
    return jobs;
}

/// Every 15 s how many are finished.
std::function<void()> progress(const std::vector<SweepCase>& cases) {
    return [&cases, seconds = 0]() mutable {
        if (++seconds % 15 != 0) return;
        const auto finished =
            std::count_if(cases.begin(), cases.end(), [](const auto& one) { return reachedTime(one.root).finished(); });
        std::cout << fmt::format("    {} of {} cases finished\n", finished, cases.size()) << std::flush;
    };
}

void runOneByOne(const Sweep& sweep, const std::vector<SweepCase>& cases) {
    for (const auto& one : cases) {
        try {
            runCase(one.root, one.name(), commandsOf(sweep), std::cout);
        } catch (const UserError& error) {
            if (interrupted()) throw;
            std::cerr << "--> PFEM Warning: " << one.name() << ": " << error.what() << "\n";
        }
    }
}

void runHere(const Sweep& sweep, const std::vector<SweepCase>& cases, const Jobs& jobs) {
    catchInterrupts();
    const bool parallel = jobs.atOnce > 1 && hasGnuParallel();
    if (jobs.atOnce > 1 && !parallel)
        std::cout << "GNU parallel is not installed (Debian: parallel): the cases run one after the other\n";
    if (!parallel) return runOneByOne(sweep, cases);
    std::cout << fmt::format("{} cases to run, {} at the same time\n", jobs.numbers.size(), jobs.atOnce) << std::flush;
    if (!jobs.numbers.empty()) runParallel(jobs, progress(cases));
    if (interrupted()) throw UserError("stopped; the same command goes on from here");
}

int runOne(const Sweep& sweep, const std::vector<SweepCase>& cases, int number) {
    catchInterrupts();
    const auto& one = cases[static_cast<std::size_t>(number - 1)];
    runCase(one.root, one.name(), commandsOf(sweep), std::cout);
    return 0;
}

/// Table and picture; returns the number of cases without results.
int gatherInto(const fs::path& folder, const Sweep& sweep, const std::vector<SweepCase>& cases) {
    const auto rows = gather(sweep, cases);
    const std::string table = resultsTable(sweep, rows);
    writeAtomically(folder / "results.csv", table);
    writeAtomically(folder / "results.gp", sweepPlot(sweep, rows));
    drawPicture(folder, "results");
    std::cout << "\n" << table << "\n";
    int unfinished = 0;
    for (const auto& row : rows) {
        if (row.reached.finished()) continue;
        ++unfinished;
        std::cout << fmt::format("{}: not finished, at {:.6g} of {:.6g} s; logs in \"{}\"\n", row.theCase.name(),
                                 row.reached.latest.value_or(0), row.reached.endTime, row.theCase.root.string());
    }
    return unfinished;
}

int submitted(const Jobs& jobs) {
    if (jobs.numbers.empty()) {
        std::cout << "All cases are finished: gather them with -noRun\n\nEnd\n\n";
        return 0;
    }
    const std::string job = submit(jobs);
    std::cout << fmt::format(
        "{0} cases are job array {1} of Slurm: squeue -j {1}; when they have ended: {2} -noRun\n\nEnd\n\n",
        jobs.numbers.size(), job, fs::path(jobs.program).filename().string());
    return 0;
}

int sweepMain(const Options& options) {
    const Case theCase = options.openCase();
    const Sweep sweep = readSweep(Dictionary::read(theCase.system("sweepDict")));
    const fs::path folder = theCase.root() / options.get("folder", "sweep");
    const auto cases = sweepCases(sweep, folder);
    if (options.found("run"))
        return runOne(sweep, cases, wholeNumber(options, "run", 1, 1, static_cast<int>(cases.size())));

    std::cout << startBanner(options, theCase);
    checkSweep(theCase, sweep);
    fs::create_directories(folder);
    const RunLock lock(folder, options.program());
    const bool run = !options.found("noRun");
    Jobs jobs = jobsOf(options, theCase, sweep, folder);
    for (const auto& one : cases) {
        makeSweepCase(theCase, sweep, one,
                      !run                         ? Copying::compareOnly
                      : options.found("overwrite") ? Copying::overwrite
                                                   : Copying::keep);
        if (run && !reachedTime(one.root).finished()) jobs.numbers.push_back(one.number);
    }
    writeAtomically(folder / "cases.csv", casesTable(sweep, cases));
    std::cout << fmt::format("{} cases, {} finished\n", cases.size(), cases.size() - jobs.numbers.size()) << std::flush;
    if (options.found("submit")) return submitted(jobs);
    if (run) runHere(sweep, cases, jobs);
    const int unfinished = gatherInto(folder, sweep, cases);
    std::cout << fmt::format("Table and picture: \"{}\"\n\nEnd\n\n", (folder / "results.csv").string());
    return unfinished > 0 && run ? 1 : 0;
}

}  // namespace

int main(int argc, char* argv[]) {
    return runApplication(
        argc, argv,
        "Run a case many times with other entries of its dictionaries, as system/sweepDict says, and gather what "
        "probes "
        "and other functions found into one table. The same command again goes on where it was stopped.",
        sweepOptions(), sweepMain);
}
