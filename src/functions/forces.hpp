#pragma once
// `type forces`: what the fluid does to walls and solids, and what supports must bear.

#include <optional>

#include "conditions/problem.hpp"
#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"
#include "solver/controls.hpp"

namespace pfem {

struct ForcesEntries {
    std::vector<std::string> patches;
    std::vector<std::string> solids;
    Eigen::Vector3d CofR{0, 0, 0};

    template <class Visitor>
    void entries(Visitor& v) {
        v("patches", patches, "-",
          "walls: the fluid's force on them; clamped and symmetry patches: the reaction of the support");
        v("solids", solids, "-", "materials of solids: the fluid's force on their wetted faces");
        v("CofR", CofR, "m", "the point that moments are taken about");
    }
};

/// Force [N/m (2D), N] and moment about the origin [N, N m].
struct ForceAndMoment {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();

    void add(const Eigen::Vector3d& x, const Eigen::Vector3d& f) {
        force += f;
        moment += x.cross(f);
    }
    /// The moment about another point.
    Eigen::Vector3d momentAbout(const Eigen::Vector3d& point) const { return moment - point.cross(force); }
};

struct FluidForce {
    ForceAndMoment pressure, viscous;
};

/// Fluid on the walls of `patches` and on the solids of `materials` (indices): the sum of faceForce over
/// their wet faces; on solids with the meniscus (momentum/meniscus.hpp) in `pressure`.
template <int Dim>
FluidForce fluidForce(const Problem<Dim>& problem, const State<Dim>& state, const std::vector<int>& patches,
                      const std::vector<int>& materials);

/// Force of the supports `patches` on what they hold, by the momentum balance of their nodes; each node
/// counts once.
template <int Dim>
ForceAndMoment reaction(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state,
                        const std::vector<int>& patches);

/// Writes postProcessing/<name>/<startTime>/ force.dat and moment.dat as OpenFOAM does (total, pressure,
/// viscous) when walls or solids are named, reaction.dat (force, moment) when supports are; per metre of
/// depth in 2D.
template <int Dim>
class Forces : public FunctionObject<Dim> {
public:
    Forces(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    void sortNames(const State<Dim>& state);

    Dictionary dict_;
    FunctionContext<Dim> context_;
    ForcesEntries entries_;
    std::optional<Problem<Dim>> problem_;
    Controls controls_;
    std::vector<int> walls_, supports_, materials_;
    std::optional<Table> force_, moment_, reaction_;
};

}  // namespace pfem
