// Fluid mass over the time folders, split by the causes in the ledger. Exit code 1 beyond the tolerance.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "application/dimension.hpp"
#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "base/error.hpp"
#include "functions/massLedger.hpp"
#include "io/stateFiles.hpp"

using namespace pfem;

namespace {

void printTable(const std::vector<MassBalance>& rows) {
    const auto causes = causesOf(rows);
    for (const auto& title : massTitles(causes)) fmt::print(" {:>16}", title);
    for (const auto& row : rows) {
        fmt::print("\n");
        for (const double value : massColumns(row, causes)) fmt::print(" {:>16.8g}", value);
    }
    fmt::print("\n\n");
}

/// The largest part of the volume that pressure has taken or given, when it is worth a line.
void printCompression(const std::vector<MassBalance>& rows) {
    double largest = 0, time = 0;
    for (const auto& row : rows) {
        const auto compression = row.causes.find(textOf(VolumeCause::compression).name);
        if (compression == row.causes.end() || !(row.volume > 0)) continue;
        const double part = compression->second / row.volume;
        if (std::abs(part) <= std::abs(largest)) continue;
        largest = part;
        time = row.time;
    }
    if (std::abs(largest) < 1e-5) return;
    fmt::print("Pressure changes the volume by at most {:.3g} % (at time {:g}): compression, no change of mass.\n",
               100 * largest, time);
}

/// What has come from outside or has left, by cause.
void printPassage(const MassBalance& row) {
    const double initial = row.volume - row.sumOfCauses - row.unexplained;
    for (const auto& cause : Causes<VolumeCause>::table) {
        const auto amount = row.causes.find(cause.name);
        if (cause.kind != CauseKind::passage || amount == row.causes.end() || amount->second == 0) continue;
        fmt::print("Not counted in it: {:+.3g} % by {} ({}).\n", 100 * amount->second / initial, cause.name,
                   cause.meaning);
    }
}

double readTolerance(const Options& options) {
    const auto tolerance = asNumber(options.get("tolerance", "0.015"));
    if (!tolerance || *tolerance < 0)
        throw UserError("-tolerance needs a number, not '" + options.get("tolerance") + "'");
    return *tolerance;
}

/// The balance of each time against the first of the case.
template <int Dim>
std::vector<MassBalance> balances(const Case& theCase, const std::vector<TimeFolder>& times) {
    const auto first = listTimes(theCase.root()).complete.front();
    const MassAccount<Dim> account(readState<Dim>(theCase.time(first.name)), readDensities(theCase.root()));
    std::vector<MassBalance> rows;
    for (const auto& time : times) rows.push_back(account.balance(readState<Dim>(theCase.time(time.name))));
    return rows;
}

}  // namespace

int main(int argc, char** argv) {
    OptionsSpec spec;
    spec.addTimeSelection().add("tolerance", "number", "Largest relative change of mass (default 0.015)");
    return runApplication(
        argc, argv, "Fluid mass of the written times and what changed it.", spec, [](const Options& options) {
            const Case theCase = options.openCase();
            const double tolerance = readTolerance(options);
            const auto times = selectTimes(theCase, options);
            const auto rows = withDimension(theCase.time(times.front().name),
                                            [&](auto dim) { return balances<decltype(dim)::value>(theCase, times); });
            printTable(rows);

            printCompression(rows);
            const MassBalance* worst = &rows.front();
            for (const auto& row : rows)
                if (std::abs(row.withoutPassage) > std::abs(worst->withoutPassage)) worst = &row;
            const bool good = std::abs(worst->withoutPassage) <= tolerance;
            fmt::print("The mass changes by at most {:.3g} % (at time {:g}), {} the tolerance of {:.3g} %.\n",
                       100 * worst->withoutPassage, worst->time, good ? "within" : "BEYOND", 100 * tolerance);
            printPassage(rows.back());
            return good ? 0 : 1;
        });
}
