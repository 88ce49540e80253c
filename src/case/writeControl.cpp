#include "case/writeControl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/error.hpp"

namespace pfem {

namespace {
/// Whole intervals until `time`; what is missing by rounding alone is there.
double intervals(double time, double interval) {
    const double n = time / interval;
    return std::floor(n + std::max(1e-9, 1e-15 * n));
}
}  // namespace

double asWritten(double time) {
    const double written = std::strtod(fmt::format("{:.13g}", time).c_str(), nullptr);
    return std::abs(written - time) <= 4e-16 * std::abs(time) ? written : time;
}

const std::vector<std::string>& WriteControl::modes() {
    static const std::vector<std::string> words{"timeStep", "runTime", "adjustable", "adjustableRunTime", "none"};
    return words;
}

WriteControl::WriteControl(const std::string& mode, double interval) : interval_(interval) {
    if (mode == "timeStep")
        mode_ = Mode::timeStep;
    else if (mode == "runTime")
        mode_ = Mode::runTime;
    else if (mode == "adjustable" || mode == "adjustableRunTime")
        mode_ = Mode::adjustable;
    else if (mode == "none")
        mode_ = Mode::none;
    else
        throw UserError(notValid(mode, "writeControl", modes()));
    if (mode_ == Mode::none) return;
    if (!(interval > 0) || !std::isfinite(interval)) throw UserError("'writeInterval' must be positive");
    if (mode_ == Mode::timeStep && (interval != std::floor(interval) || interval > 1e9))
        throw UserError("'writeInterval' must be a whole number of steps with writeControl timeStep");
}

bool WriteControl::due(const TimeInfo& time) const {
    if (mode_ == Mode::none) return false;
    if (mode_ == Mode::timeStep) return std::fmod(time.index, interval_) == 0;
    return time.index == 0 || intervals(time.value, interval_) > intervals(time.value - time.deltaT0, interval_);
}

WriteControl WriteControl::every(int n) const {
    WriteControl result = *this;
    result.interval_ *= n;
    return result;
}

double WriteControl::next(const TimeInfo& time) const {
    if (mode_ == Mode::none || mode_ == Mode::timeStep) return std::numeric_limits<double>::infinity();
    return asWritten((intervals(time.value, interval_) + 1) * interval_);
}

}  // namespace pfem
