#pragma once
// `type probes`: fields at points, fixed in space or riding on the material.

#include <Eigen/Core>
#include <optional>

#include "functions/functionObject.hpp"
#include "functions/sampling.hpp"
#include "io/table.hpp"

namespace pfem {

/// A point of the material: nodes by id, so that it survives remeshing and restart.
template <int Dim>
struct Anchor {
    std::array<Id, Dim + 1> ids{};
    Eigen::Matrix<double, Dim + 1, 1> weights;
    Region region = Region::fluid;
};

/// Writes postProcessing/<name>/<startTime>/<field>, a row per sample and a column per probe, in the form of
/// OpenFOAM's probes. A probe that finds no material (a dry one) gives -1e+300.
///
/// fixedLocations true (default): the point stays; values are interpolated linearly in the triangle that
/// holds it (p in the fluid, sigma in the solid, the others in the fluid or else the solid). fixedLocations
/// false: the point is attached at the first time of the case: to the solid triangle that holds it in the
/// reference configuration, or else to the fluid triangle that holds it then, and follows those nodes. What is beside a
/// triangle by a tenth of it counts as in it: round shapes have sides of chords.
template <int Dim>
class Probes : public FunctionObject<Dim> {
public:
    Probes(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    using Sample = std::optional<WeightedNodes<Dim>>;

    std::optional<Anchor<Dim>> attach(const State<Dim>& initial, const Vec<Dim>& point) const;
    void warnOfNowhere(const std::vector<bool>& found) const;
    Sample follow(const State<Dim>& state, const Anchor<Dim>& anchor) const;

    FunctionContext<Dim> context_;
    std::vector<NodalField<Dim>> fields_;
    std::vector<Eigen::Vector3d> points_;
    bool fixed_ = true;
    std::vector<std::optional<Anchor<Dim>>> anchors_;  // per probe, when attached
    std::vector<Table> tables_;                        // per field
};

}  // namespace pfem
