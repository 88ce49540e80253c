#pragma once
// `type waveReflection`: how high the waves are that go past gauges in a row, and those that come back.

#include <complex>
#include <optional>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

struct WaveReflectionEntries {
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d direction{0, 1, 0};
    double depth = 0, start = 0, window = 0;
    std::vector<double> frequencies;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("points", points, "m",
                   "feet of the gauges, two or more, in the order in which waves come past; unequal distances between "
                   "0.05 and 0.45 wave lengths tell most");
        v("direction", direction, "-", "of the gauges, upwards; in 3D against gravity where it is not given");
        v.required("depth", depth, "m", "of the still water, for the wave numbers", positive);
        v.required("window", window, "s", "time over which waves are taken in: whole periods of regular ones",
                   positive);
        v("start", start, "s", "when the first window begins; the next ones follow");
        v.required("frequencies", frequencies, "Hz",
                   "lowest and highest; multiples of 1/window between them count. Bound harmonics do not obey the "
                   "dispersion relation: leave them out");
    }
};

/// What the gauges have seen within a window.
struct WindowSums {
    std::vector<double> last;                          // elevations of the gauges
    std::vector<std::vector<std::complex<double>>> A;  // per gauge and frequency: 2/window int eta exp(-i omega t) dt
};

/// Writes postProcessing/<name>/<startTime>/waveReflection.dat, a row per window at its end: heights 4 sqrt(m0) of both
/// (H_m0; sqrt 2 H of regular waves), the root of the ratio of their energies, and the period of the largest incident
/// amplitude.
template <int Dim>
class WaveReflection : public FunctionObject<Dim> {
public:
    WaveReflection(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void advance(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;
    std::vector<double> memory() const override;

private:
    void remember(const std::vector<double>& memory);
    std::vector<double> elevations(const State<Dim>& state) const;
    void add(double from, double to, const std::vector<double>& first, const std::vector<double>& last);
    void finishWindow();

    FunctionContext<Dim> context_;
    WaveReflectionEntries entries_;
    double gravity_ = 0;
    std::vector<double> place_;  // of the gauges along the row
    std::vector<double> omega_;
    double time_ = 0, windowEnd_ = 0;
    WindowSums sums_;
    std::vector<double> finished_;  // of the last window, until its row is written
    std::optional<Table> table_;
};

}  // namespace pfem
