#include "solver/log.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

namespace pfem {

namespace {

/// The most memory that the program has had [MB].
double peakMemory() {
    rusage usage{};
    return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<double>(usage.ru_maxrss) / 1024 : 0;
}

const char* cellOf(int dim) { return dim == 2 ? "triangle" : "tetrahedron"; }
const char* cellsOf(int dim) { return dim == 2 ? "triangles" : "tetrahedra"; }

}  // namespace

std::string courantLines(const CourantRate& rate, double dt) {
    return fmt::format("Courant Number mean: {:.6g} max: {:.6g} relative: {:.6g}\ndeltaT = {:.6g}\n", rate.mean * dt,
                       rate.largest * dt, rate.relative * dt, dt);
}

template <int Dim>
std::string stepLines(const AdvanceReport& report, const State<Dim>& state, double firstVolume) {
    std::string text;
    for (const auto& reason : report.reasons) text += "Step rejected: " + reason + "\n";
    const auto& s = report.step;
    const auto solve = [&](const char* name, double first, double last, int iterations) {
        return fmt::format(
            "pfem:  Solving for {}, Initial residual = {:.6g}, Final residual = {:.6g}, No Iterations {}\n", name,
            first, last, iterations);
    };
    text += solve("U", s.initialU, s.finalU, s.iterations) + solve("p", s.initialP, s.finalP, s.iterations);
    if (!s.drive.isZero(0))
        text += fmt::format("Drive through periodic sides = ({:.6g} {:.6g} {:.6g}) m/s2\n", s.drive[0], s.drive[1],
                            s.drive[2]);
    text +=
        fmt::format("Mesh: {} nodes, {} fluid {}, removed {}, inserted {}, returned {}\n", state.nodes.size(),
                    state.mesh.fluid.size(), cellsOf(Dim), report.mesh.removed, report.mesh.inserted, report.returned);
    const double change = state.ledger.sum(CauseKind::gainOrLoss), correction = state.ledger[VolumeCause::correction],
                 volume = totalVolume<Dim>(state);
    std::string passed;
    for (const auto& [name, amount] : state.ledger.byName())
        for (const auto& cause : Causes<VolumeCause>::table)
            if (cause.kind == CauseKind::passage && cause.name == name && amount != 0)
                passed += fmt::format(", {} = {:.3g} %", name, 100 * amount / firstVolume);
    if (firstVolume > 0)  // a case may have solids only
        text += fmt::format("Fluid volume = {:.6g}, change = {:.3g} %, raw = {:.3g} %{}\n", volume,
                            100 * change / firstVolume, 100 * (change - correction) / firstVolume, passed);
    return text;
}

std::string timeLines(double cpu, double clock, double fraction) {
    const double left = fraction > 0 ? clock * (1 - fraction) / fraction : 0;
    return fmt::format(
        "ExecutionTime = {:.2f} s  ClockTime = {:.0f} s\nProgress = {:.1f} %, estimated time left = {:.0f} s\n\n", cpu,
        clock, 100 * fraction, left);
}

void RunSummary::add(const AdvanceReport& report, int cells) {
    cells_ += cells;
    iterations_.push_back(report.step.iterations);
    rejected_ += report.rejected;
    step_ += report.seconds[0];
    remeshing_ += report.seconds[1];
}

std::string RunSummary::text(double clock, int dim) const {
    if (iterations_.empty()) return "";
    auto sorted = iterations_;
    std::sort(sorted.begin(), sorted.end());
    const auto steps = static_cast<double>(sorted.size());
    const auto share = [&](double seconds) { return 100 * seconds / std::max(clock, 1e-9); };
    return fmt::format(
        "Summary: {} steps, {} rejected ({:.2f} %), iterations median {}, largest {}\n"
        "         {:.1f} ms per step: equations {:.0f} %, remeshing {:.0f} %, output and the rest {:.0f} %\n"
        "         {:.0f} {} on average, {:.2f} microseconds per {} and step, at most {:.0f} MB of memory\n\n",
        sorted.size(), rejected_, 100 * rejected_ / steps, sorted[sorted.size() / 2], sorted.back(),
        1000 * clock / steps, share(step_), share(remeshing_), share(clock - step_ - remeshing_), cells_ / steps,
        cellsOf(dim), 1e6 * clock / std::max(cells_, 1.0), cellOf(dim), peakMemory());
}

#define PFEM_INSTANTIATE(D) template std::string stepLines<D>(const AdvanceReport&, const State<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
