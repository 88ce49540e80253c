#include "functions/timeFilter.hpp"

#include <cmath>

namespace pfem {

namespace {

/// Mean of the piecewise linear signal over the last T, or over all when it is shorter.
double windowMean(const std::deque<std::pair<double, double>>& samples, double T) {
    const double end = samples.back().first;
    double sum = 0, length = 0;
    for (std::size_t k = samples.size() - 1; k > 0; --k) {
        auto [t0, s0] = samples[k - 1];
        const auto [t1, s1] = samples[k];
        if (t1 <= end - T) break;
        if (t0 < end - T) {
            s0 += (s1 - s0) * (end - T - t0) / (t1 - t0);
            t0 = end - T;
        }
        sum += 0.5 * (s0 + s1) * (t1 - t0);
        length += t1 - t0;
    }
    return length > 0 ? sum / length : samples.back().second;
}

}  // namespace

const std::vector<std::string>& TimeFilter::kinds() {
    static const std::vector<std::string> words{"none", "lowPass", "movingAverage"};
    return words;
}

TimeFilter::TimeFilter(const std::string& kind, double T) : kind_(kind), T_(T) {}

double TimeFilter::advance(double time, double value) {
    if (!samples_.empty() && time <= samples_.back().first) return value_;
    if (samples_.empty() || kind_ == "none") {
        value_ = value;
        samples_.assign(1, {time, value});
    } else if (kind_ == "lowPass") {
        value_ += -std::expm1(-(time - samples_.back().first) / T_) * (value - value_);
        samples_.assign(1, {time, value});
    } else {
        samples_.emplace_back(time, value);
        while (samples_.size() > 2 && samples_[1].first <= time - T_) samples_.pop_front();
        value_ = windowMean(samples_, T_);
    }
    return value_;
}

std::vector<double> TimeFilter::memory() const {
    std::vector<double> numbers{value_};
    for (const auto& [time, value] : samples_) numbers.insert(numbers.end(), {time, value});
    return numbers;
}

void TimeFilter::recall(const std::vector<double>& memory) {
    if (memory.empty()) return;
    value_ = memory[0];
    samples_.clear();
    for (std::size_t i = 1; i + 1 < memory.size(); i += 2) samples_.emplace_back(memory[i], memory[i + 1]);
}

}  // namespace pfem
