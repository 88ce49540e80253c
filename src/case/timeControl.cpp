#include "case/timeControl.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "case/interrupt.hpp"
#include "dictionary/flatEntries.hpp"

namespace pfem {

namespace fs = std::filesystem;

namespace {

constexpr double sameTime = 1e-6;  // of a step: nearer than this means equal
constexpr double stretch = 0.01;   // of a step: so much longer it may be to end on a wanted time

/// The folder that startFrom asks for.
std::string chooseStart(const Case& theCase, const ControlDict& controls) {
    const TimeFolders times = listTimes(theCase.root());
    std::string ignored;
    for (const auto& folder : times.ignored) ignored += "\n    ignored " + folder.name + ": " + folder.reason;
    for (const auto& folder : times.ignored)
        std::cerr << "--> PFEM Warning : time folder " << folder.name << " is ignored: " << folder.reason << "\n";
    if (times.complete.empty())
        throw UserError("no time folder in case \"" + theCase.root().string() + "\": run pfemMesh first" + ignored);
    if (controls.startFrom == "firstTime") return times.complete.front().name;
    if (controls.startFrom == "latestTime") return times.complete.back().name;
    std::string known;
    for (const auto& folder : times.complete) {
        if (std::abs(folder.value - controls.startTime) <= 1e-9 * std::max(controls.deltaT, std::abs(folder.value)))
            return folder.name;
        known += " " + folder.name;
    }
    throw UserError("no time folder for startTime " + timeName(controls.startTime) + "; there are:" + known + ignored,
                    {theCase.controlDict().string(), 0});
}

/// Times after the start are of an earlier run, and would be mixed with those of this one.
void warnOfLaterTimes(const Case& theCase, const std::string& start) {
    auto times = listTimes(theCase.root()).complete;
    std::erase_if(times, [&](const TimeFolder& folder) { return folder.value <= *asNumber(start); });
    if (times.empty()) return;
    std::cerr << "--> PFEM Warning : after the start at " << start << " there are " << times.size()
              << " times of an earlier run, " << times.front().name << " to " << times.back().name
              << ". Each stays until this run writes a time of that name; 'pfemListTimes -rm -time "
              << times.front().name << ":' removes them\n";
}

fs::file_time_type modificationTime(const fs::path& file) {
    std::error_code error;
    return fs::last_write_time(file, error);
}

/// Of controlDict and what it includes.
std::map<std::string, fs::file_time_type> modificationTimes(const Dictionary& dict) {
    std::map<std::string, fs::file_time_type> times;
    for (const auto& file : filesOf(dict)) times[file] = modificationTime(file);
    return times;
}

}  // namespace

TimeControl::TimeControl(const Case& theCase)
    : root_(theCase.root()),
      file_(theCase.controlDict()),
      readAt_{{file_.string(), modificationTime(file_)}},
      dict_(Dictionary::read(file_)),
      controls_(readControlDict(dict_)),
      write_(writeControlOf(controls_)),
      startName_(chooseStart(theCase, controls_)) {
    readAt_.merge(modificationTimes(dict_));
    catchInterrupts();
    warnOfLaterTimes(theCase, startName_);
    stop_ = controls_.stopAt == "writeNow" || controls_.stopAt == "noWriteNow";
    if (stop_)
        std::cerr << "--> PFEM Warning : nothing to do: 'stopAt " << controls_.stopAt << "' in " << file_.string()
                  << "\n";
}

/// Steps of one length, counted from 0: neither by the flow nor by the write times.
bool TimeControl::fixed() const { return !controls_.adjustTimeStep && !write_.adjustable(); }

/// The longest step that the limits of controlDict allow.
double TimeControl::longest(const TimeInfo& time, const StepRates& rates) const {
    if (!controls_.adjustTimeStep) return controls_.deltaT;
    const bool first = time.index == 0 || !(time.deltaT0 > 0);
    double dt = std::min(first ? controls_.deltaT : controls_.maxGrowth * time.deltaT0, controls_.maxDeltaT);
    const auto limit = [&](double most, double rate) {
        if (rate > 0) dt = std::min(dt, most / rate);
    };
    limit(controls_.maxCo, rates.courant);
    limit(controls_.maxRelativeCo, rates.relative);
    limit(controls_.maxCompression, rates.compression);
    limit(controls_.maxWaveCo, rates.gravityWave);
    limit(controls_.maxSolidCo, rates.elasticWave);
    return dt;
}

/// The next time that a step of length dt must not jump over. A fixed step that was cut (rejected, or by an end of the
/// run) is made up for: the next time is a multiple of deltaT again.
double TimeControl::target(const TimeInfo& time, double dt) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double end = time.value < controls_.endTime ? controls_.endTime : never;
    if (write_.adjustable()) return std::min(write_.next(time), end);
    if (!fixed()) return end;
    const double nearEnd = end - time.value < (1 + stretch) * dt ? end : never;
    const bool cut = time.deltaT == controls_.deltaT && time.deltaT0 < (1 - sameTime) * time.deltaT;
    if (!cut) return nearEnd;
    return std::min(nearEnd, asWritten((std::floor(time.value / controls_.deltaT + 0.1) + 1) * controls_.deltaT));
}

/// Nothing is left of the step to come.
bool TimeControl::ended(const TimeInfo& time) const {
    return time.value >= controls_.endTime - sameTime * longest(time, {});
}

bool TimeControl::running(const TimeInfo& time) const { return !stop_ && !ended(time); }

double TimeControl::deltaT(const TimeInfo& time, const StepRates& rates) const {
    const double dt = longest(time, rates);
    const double left = target(time, dt) - time.value;
    const double steps = left / dt;
    if (!(steps < 1e9)) return dt;
    const double n = std::max(1.0, std::floor(steps + 1 - stretch));
    const double even = left / n;
    return std::abs(even - dt) <= sameTime * dt ? dt : even;  // keep dt's bits while rounding alone differs
}

TimeInfo TimeControl::advance(const TimeInfo& time, double dt) const {
    TimeInfo next = time;
    next.value = time.value + dt;
    const double multiple = asWritten(std::round(next.value / controls_.deltaT) * controls_.deltaT);
    if (!controls_.adjustTimeStep && std::abs(next.value - multiple) <= sameTime * dt) next.value = multiple;
    const double wanted = target(time, longest(time, {}));
    if (std::abs(next.value - wanted) <= sameTime * dt) next.value = wanted;
    next.index = time.index + 1;
    next.deltaT = fixed() ? std::max(dt, controls_.deltaT) : dt;
    next.deltaT0 = dt;
    return next;
}

bool TimeControl::writeDue(const TimeInfo& time) {
    readAgainIfChanged();
    const bool due = folderDue(time);
    if (interrupted()) {
        stop_ = true;
        return true;
    }
    if (controls_.stopAt == "endTime") return due;
    stop_ = stop_ || controls_.stopAt != "nextWrite" || due;
    return controls_.stopAt == "writeNow" || (controls_.stopAt == "nextWrite" && due);
}

void TimeControl::readAgainIfChanged() {
    if (!controls_.runTimeModifiable) return;
    bool changed = false;
    for (auto& [file, time] : readAt_) {
        const auto before = std::exchange(time, modificationTime(file));
        changed = changed || before != time;
    }
    if (!changed) return;
    try {
        Dictionary dict = Dictionary::read(file_);
        const ControlDict controls = readControlDict(dict);
        write_ = writeControlOf(controls);
        const std::string changes = differences(flatEntries(dict_), flatEntries(dict));
        std::cout << "Re-reading " << file_.string() << "\n" << changes;
        for (const std::string key : {"functions", "startFrom", "startTime", "writePrecision", "libs"})
            if (changes.find("    " + key) != std::string::npos)
                std::cout << "    (" << key << ": from the next start on)\n";
        controls_ = controls;
        dict_ = std::move(dict);
        readAt_.merge(modificationTimes(dict_));
    } catch (const UserError& error) {  // perhaps just being edited: a running job must not die of it
        std::cerr << "--> PFEM Warning : " << file_.string()
                  << " was changed but cannot be used, the old settings stay: " << error.what() << "\n";
    }
}

std::string TimeControl::name(const TimeInfo& time) const {
    const int precision =
        precisionToDistinguish(time.value - time.deltaT0, time.value, controls_.timeFormat, controls_.timePrecision);
    return timeName(time.value, controls_.timeFormat, precision);
}

bool TimeControl::written(const TimeInfo& time) {
    const std::string current = name(time);
    if (names_.empty() || names_.back() != current) names_.push_back(current);
    bool removed = false;
    while (controls_.purgeWrite > 0 && static_cast<int>(names_.size()) > controls_.purgeWrite) {
        std::error_code ignored;
        if (asNumber(names_.front()) != 0.0) removeTime(root_, names_.front(), ignored);
        names_.pop_front();
        removed = true;
    }
    return removed;
}

}  // namespace pfem
