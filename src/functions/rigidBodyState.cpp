#include "functions/rigidBodyState.hpp"

#include <cmath>
#include <map>

#include "base/vectors.hpp"
#include "conditions/rigidBodies.hpp"
#include "solver/setup.hpp"

namespace pfem {

namespace {

/// Angles about x, y, z, one after the other, in degrees.
template <int Dim>
std::vector<double> angles(const Tensor<Dim>& turn) {
    constexpr double degree = M_PI / 180;
    if constexpr (Dim == 2)
        return {0, 0, std::atan2(turn(1, 0), turn(0, 0)) / degree};
    else
        return {std::atan2(turn(2, 1), turn(2, 2)) / degree, -std::asin(std::clamp(turn(2, 0), -1.0, 1.0)) / degree,
                std::atan2(turn(1, 0), turn(0, 0)) / degree};
}

}  // namespace

template <int Dim>
RigidBodyState<Dim>::RigidBodyState(const Dictionary& dict, const FunctionContext<Dim>& context)
    : context_(context), where_(dict.where("type")) {}

template <int Dim>
void RigidBodyState<Dim>::start(const State<Dim>& state) {
    problem_ = readProblem<Dim>(Case(context_.root), state, nullptr);
    const auto bodies = rigidBodies<Dim>(*problem_, state.mesh, state.nodes);
    if (bodies.empty()) throw UserError("there is no rigid body: no material of 'type rigid;'", where_);
    std::map<int, int> count, written;
    for (const auto& body : bodies) ++count[body.material];
    for (const auto& body : bodies) {
        std::string name = problem_->materials[body.material].name;
        if (count[body.material] > 1) name += std::to_string(++written[body.material]);
        tables_.emplace_back(context_.folder / (name + ".dat"), context_.precision, context_.resumeAt);
        tables_.back().comment("Motion State");
        tables_.back().comment("Angle Units  : degrees");
        tables_.back().comment("Time\tcentreOfRotation\tcentreOfMass\trotation\tvelocity\tomega");
    }
}

template <int Dim>
void RigidBodyState<Dim>::execute(const State<Dim>& state) {
    const auto bodies = rigidBodies<Dim>(*problem_, state.mesh, state.nodes);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody<Dim>& body = bodies[b];
        Table& table = tables_[b];
        const Vec<Dim> velocity = leverRows<Dim>(body.pose.lever(body.centre)) * body.twist;
        std::vector<double> omega{0, 0, body.twist[nTwist<Dim> - 1]};
        if constexpr (Dim == 3) omega = threeNumbers<3>(body.twist.template tail<3>());
        std::string line = table.time(state.time.value);
        for (const auto& values : {threeNumbers<Dim>(body.pose.at), threeNumbers<Dim>(body.pose.place(body.centre)),
                                   angles<Dim>(body.pose.turn), threeNumbers<Dim>(velocity), omega})
            line += "\t" + table.tuple(values);
        table.line(line);
    }
}

#define PFEM_INSTANTIATE(D) template class RigidBodyState<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
