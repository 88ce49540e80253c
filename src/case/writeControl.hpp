#pragma once
// When something is written: every n steps, every so many seconds, never.

#include <string>
#include <vector>

#include "case/timeInfo.hpp"

namespace pfem {

/// The number that a user would write: 188 times 0.005 is 0.94, as in `endTime 0.94`, not 0.9400000000000001. Otherwise
/// a run that ends there and goes on later would differ from an unbroken one in the last bit.
double asWritten(double time);

class WriteControl {
public:
    /// The valid words for `writeControl`.
    static const std::vector<std::string>& modes();

    /// `mode`: one of modes(). `interval`: steps (timeStep) or seconds. Throws UserError when the interval
    /// is not positive, or for timeStep not a whole number.
    WriteControl(const std::string& mode, double interval);

    /// adjustable: steps are shortened so that they end exactly on k*interval.
    bool adjustable() const { return mode_ == Mode::adjustable; }

    /// Is something to be written at the end of the step that led to `time`? Depends on `time` and nothing
    /// else, so that a restarted run writes at the same times.
    bool due(const TimeInfo& time) const;

    /// Every n-th of these times.
    WriteControl every(int n) const;

    /// The first k*interval behind time.value; infinite for timeStep and none.
    double next(const TimeInfo& time) const;

private:
    enum class Mode { timeStep, runTime, adjustable, none };
    Mode mode_;
    double interval_;
};

}  // namespace pfem
