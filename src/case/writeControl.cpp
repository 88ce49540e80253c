#include "case/writeControl.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/error.hpp"

namespace pfem {

namespace {
constexpr double rounding = 1e-9;  // of an interval: times closer than this are the same

/// The number that a user would write: 188 times 0.005 is 0.94, as in `endTime 0.94`, not 0.9400000000000001.
/// Otherwise a run that ends there and goes on later would differ from an unbroken one in the last bit.
double asWritten(double time) {
    return std::strtod(fmt::format("{:.13g}", time).c_str(), nullptr);
}
}  // namespace

const std::vector<std::string>& WriteControl::modes() {
    static const std::vector<std::string> words{"timeStep", "runTime", "adjustable", "adjustableRunTime",
                                                "none"};
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
    if (mode_ == Mode::timeStep) return time.index % static_cast<int>(interval_) == 0;
    const double now = std::floor(time.value / interval_ + rounding);
    const double before = std::floor((time.value - time.deltaT0) / interval_ + rounding);
    return time.index == 0 || now > before;
}

double WriteControl::next(const TimeInfo& time) const {
    if (mode_ == Mode::none || mode_ == Mode::timeStep) return std::numeric_limits<double>::infinity();
    return asWritten((std::floor(time.value / interval_ + rounding) + 1.0) * interval_);
}

}  // namespace pfem
