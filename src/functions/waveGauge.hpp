#pragma once
// `type waveGauge`: where the free surface is above a point.

#include <optional>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

struct WaveGaugeEntries {
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d direction{0, 1, 0};

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("points", points, "m", "feet of the gauges; elevations are counted from here");
        v("direction", direction, "-", "of the gauges, upwards; in 3D against gravity where it is not given");
    }
};

/// What a gauge sees of the fluid's cells on its line; nothing when it is dry. Isolated drops are not seen.
struct GaugeReading {
    double elevation = 0;  // upper end of the lowest stretch of fluid without a gap [m]
    double highest = 0;    // of all fluid [m]
    double depth = 0;      // length of line within fluid [m]
};

/// Exact for straight pieces of surface. `direction`: a unit vector.
template <int Dim>
std::optional<GaugeReading> readGauge(const State<Dim>& state, const Vec<Dim>& foot, const Vec<Dim>& direction);

/// Against gravity at time 0 of the case; without gravity z.
Vec<3> upwards(const std::filesystem::path& root);

/// Writes postProcessing/<name>/<startTime>/ elevation, highest and depth in the form of OpenFOAM's probes; a
/// dry gauge gives -1e+300.
template <int Dim>
class WaveGauge : public FunctionObject<Dim> {
public:
    WaveGauge(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    WaveGaugeEntries entries_;
    std::vector<Table> tables_;  // elevation, highest, depth
};

}  // namespace pfem
