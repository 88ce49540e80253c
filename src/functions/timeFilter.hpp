#pragma once
// Causal filters of a signal that comes in steps of any length.

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace pfem {

/// none:           the signal s itself.
/// lowPass:        dS/dt = (s - S)/T, S = s at the beginning; s constant over each step at its new value.
/// movingAverage:  S(t) = (1/T) int_{t-T}^t s dt, s piecewise linear; over what there is at the beginning.
class TimeFilter {
public:
    static const std::vector<std::string>& kinds();

    /// `kind`: one of kinds(). `T` [s] > 0.
    TimeFilter(const std::string& kind, double T);

    /// The signal at the next time; returns the filtered value. The same time again changes nothing.
    double advance(double time, double value);
    double value() const { return value_; }

    /// All that a restart needs, and back.
    std::vector<double> memory() const;
    void recall(const std::vector<double>& memory);

private:
    std::string kind_;
    double T_;
    double value_ = 0;
    std::deque<std::pair<double, double>> samples_;  // (time, signal): what the window needs; lowPass: the last
};

}  // namespace pfem
