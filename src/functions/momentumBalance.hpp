#pragma once
// `type momentumBalance`: momentum of the fluid between two planes, and what changes it.

#include <optional>

#include "dictionary/entries.hpp"
#include "functions/controlVolume.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

struct MomentumBalanceEntries {
    Eigen::Vector3d from{0, 0, 0}, to{0, 0, 0};
    double width = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("from", from, "m", "a point of the plane with which the control volume begins");
        v.required(
            "to", to, "m",
            "a point of the plane with which it ends; both planes are normal to the way between them, along which "
            "momentum counts. They keep away from openings");
        v("width", width, "m",
          "of the layers about the planes over which the flow through them is averaged; 0: four mesh sizes",
          nonNegative);
    }
};

/// Writes postProcessing/<name>/<startTime>/momentumBalance.dat: the momentum, the rates above integrated over every
/// step since the beginning by the trapezoidal rule, and what of the change of momentum they do not explain.
template <int Dim>
class MomentumBalance : public FunctionObject<Dim> {
public:
    MomentumBalance(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void advance(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;
    std::vector<double> memory() const override;
    bool usesThreads() const override { return true; }

private:
    FunctionContext<Dim> context_;
    ControlVolume<Dim> volume_;
    std::optional<Problem<Dim>> problem_;
    Controls controls_;
    double first_ = 0, time_ = 0;
    std::array<double, 7> rates_{}, sums_{};
    std::optional<Table> table_;
};

}  // namespace pfem
