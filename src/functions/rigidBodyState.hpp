#pragma once
// `type rigidBodyState`: where rigid bodies are and how they move.

#include <optional>
#include <vector>

#include "conditions/problem.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

/// Writes postProcessing/<name>/<startTime>/<material>.dat for each rigid body (of several of one material:
/// <material>1.dat, ...): time, centreOfRotation and centreOfMass [m], rotation since the reference state [degrees;
/// about x, y and z in this order], velocity of the centre of mass [m/s], omega [rad/s], as OpenFOAM's
/// sixDoFRigidBodyState.
template <int Dim>
class RigidBodyState : public FunctionObject<Dim> {
public:
    RigidBodyState(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    Location where_;
    std::optional<Problem<Dim>> problem_;
    std::vector<Table> tables_;
};

}  // namespace pfem
