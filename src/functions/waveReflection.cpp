#include "functions/waveReflection.hpp"

#include <cmath>

#include "dictionary/function1.hpp"
#include "functions/sensors.hpp"
#include "functions/waveGauge.hpp"
#include "waves/dispersion.hpp"
#include "waves/reflection.hpp"

namespace pfem {

template <int Dim>
WaveReflection<Dim>::WaveReflection(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    readEntries(dict, entries_);
    auto& [points, direction, depth, start, window, frequencies] = entries_;
    if (Dim == 3 && !dict.found("direction")) direction = upwards(context.root);
    if (!(direction.template head<Dim>().norm() > 0)) dict.fatal("direction", "the direction has no length");
    if (Dim == 2) demandPlane(dict, "direction", direction[2]);
    direction.normalize();
    if (points.size() < 2) dict.fatal("points", "two gauges at least tell waves that come from those that go");
    if (frequencies.size() != 2 || !(frequencies[0] > 0 && frequencies[1] >= frequencies[0]))
        dict.fatal("frequencies", "the lowest and the highest one are wanted: frequencies (0.4 1.5);");
    const double slack = 1e-9;
    for (double n = std::ceil(frequencies[0] * window - slack); n <= frequencies[1] * window + slack; ++n)
        omega_.push_back(2 * M_PI * n / window);
    if (omega_.empty()) dict.fatal("frequencies", "between them there is no multiple of 1/window");
    const Eigen::Vector3d row = points.back() - points.front(), along = row - direction * direction.dot(row);
    if (!(along.norm() > 0)) dict.fatal("points", "the first and the last gauge are at the same place");
    for (const auto& point : points) place_.push_back(along.normalized().dot(point - points.front()));
    gravity_ =
        readFunction1<Eigen::Vector3d>(Dictionary::read(context.root / "constant" / "g"), "value")->value(0).norm();
}

template <int Dim>
std::vector<double> WaveReflection<Dim>::elevations(const State<Dim>& state) const {
    std::vector<double> result;
    const Vec<Dim> up = entries_.direction.head<Dim>().normalized();
    for (const auto& point : entries_.points) {
        const auto reading = readGauge<Dim>(state, point.head<Dim>(), up);
        result.push_back(reading ? reading->elevation : 0);  // a dry bed
    }
    return result;
}

template <int Dim>
void WaveReflection<Dim>::start(const State<Dim>& state) {
    time_ = state.time.value;
    windowEnd_ = entries_.start + entries_.window;
    finished_.clear();
    sums_.last = elevations(state);
    sums_.A.assign(place_.size(), std::vector<std::complex<double>>(omega_.size(), 0.0));
    if (const auto found = state.memory.find(context_.name); found != state.memory.end()) remember(found->second);
    table_.emplace(context_.folder / "waveReflection.dat", context_.precision, context_.resumeAt);
    table_->comment(
        "Heights 4 sqrt(m0) [m] of incident and reflected waves, root of the ratio of their energies, "
        "period of the largest incident one [s], within a window that ends at Time");
    table_->header({"Time", "incident", "reflected", "coefficient", "peakPeriod"});
}

template <int Dim>
std::vector<double> WaveReflection<Dim>::memory() const {
    std::vector<double> numbers{windowEnd_};
    for (const auto& ofGauge : sums_.A)
        for (const auto& amplitude : ofGauge) numbers.insert(numbers.end(), {amplitude.real(), amplitude.imag()});
    numbers.insert(numbers.end(), finished_.begin(), finished_.end());
    return numbers;
}

template <int Dim>
void WaveReflection<Dim>::remember(const std::vector<double>& memory) {
    const std::size_t nSums = 1 + 2 * place_.size() * omega_.size();
    if (memory.size() < nSums) return;  // of other gauges
    windowEnd_ = memory[0];
    std::size_t at = 1;
    for (auto& ofGauge : sums_.A)
        for (auto& amplitude : ofGauge) {
            amplitude = {memory[at], memory[at + 1]};
            at += 2;
        }
    finished_.assign(memory.begin() + static_cast<std::ptrdiff_t>(nSums), memory.end());
}

/// The trapezoidal rule.
template <int Dim>
void WaveReflection<Dim>::add(double from, double to, const std::vector<double>& first,
                              const std::vector<double>& last) {
    for (std::size_t f = 0; f < omega_.size(); ++f) {
        const auto weight = (to - from) / entries_.window;  // 2/window times half of the step
        const auto before = std::polar(weight, -omega_[f] * from), after = std::polar(weight, -omega_[f] * to);
        for (std::size_t m = 0; m < place_.size(); ++m) sums_.A[m][f] += first[m] * before + last[m] * after;
    }
}

template <int Dim>
void WaveReflection<Dim>::finishWindow() {
    double incident = 0, reflected = 0, largest = 0, peak = 0;
    for (std::size_t f = 0; f < omega_.size(); ++f) {
        std::vector<std::complex<double>> A;
        for (auto& ofGauge : sums_.A) A.push_back(std::exchange(ofGauge[f], 0.0));
        const auto waves = separateWaves(place_, A, waveNumber(omega_[f], entries_.depth, gravity_));
        if (!waves) continue;
        const double energy = std::norm(waves->incident);
        incident += 0.5 * energy;
        reflected += 0.5 * std::norm(waves->reflected);
        if (energy > largest) largest = energy, peak = 2 * M_PI / omega_[f];
    }
    finished_ = {windowEnd_, 4 * std::sqrt(incident), 4 * std::sqrt(reflected),
                 incident > 0 ? std::sqrt(reflected / incident) : 0, peak};
    windowEnd_ += entries_.window;
}

template <int Dim>
void WaveReflection<Dim>::advance(const State<Dim>& state) {
    const double t = state.time.value;
    if (!(t > time_)) return;
    const auto now = elevations(state);
    const auto at = [&](double when) {
        std::vector<double> between;
        for (std::size_t m = 0; m < now.size(); ++m)
            between.push_back(sums_.last[m] + (when - time_) / (t - time_) * (now[m] - sums_.last[m]));
        return between;
    };
    double from = std::max(time_, windowEnd_ - entries_.window);
    while (from < t) {  // a step may end one window and begin the next
        const double to = std::min(t, windowEnd_);
        if (to > from) add(from, to, at(from), at(to));
        if (to == windowEnd_) finishWindow();
        from = to;
    }
    sums_.last = now;
    time_ = t;
}

template <int Dim>
void WaveReflection<Dim>::execute(const State<Dim>&) {
    if (finished_.empty()) return;
    std::vector<std::string> row{table_->time(finished_[0])};
    for (std::size_t k = 1; k < finished_.size(); ++k) row.push_back(table_->number(finished_[k]));
    table_->row(row);
    finished_.clear();
}

#define PFEM_INSTANTIATE(D) template class WaveReflection<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
