#include "solver/checkWaves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waves/dispersion.hpp"

namespace pfem {

namespace {

/// Mean of h over the corners of the fluid's cells; 0 without fluid.
template <int Dim>
double meshSizeOfFluid(const State<Dim>& state) {
    double sum = 0;
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int node : cell) sum += state.nodes.h[node];
    return state.mesh.fluid.nodes.empty() ? 0 : sum / ((Dim + 1) * state.mesh.fluid.size());
}

void lookAt(const Dictionary& dict, double h, std::vector<std::string>& found) {
    for (const auto& key : dict.keys())
        if (dict.isDict(key)) lookAt(dict.subDict(key), h, found);
    if (!dict.found("type") || dict.get<std::string>("type") != "waveMaker" || !dict.found("period")) return;
    const double omega = 2 * M_PI / dict.get<double>("period");
    const double length = 2 * M_PI / waveNumber(omega, dict.get<double>("depth"), dict.get("gravity", 9.81));
    if (length >= 8 * h) return;
    const Location at = dict.where("period");
    found.push_back(
        fmt::format("entry 'period' in {}:{}: these waves are {:.3g} m long, less than eight mesh sizes of "
                    "{:.3g} m: they will not travel",
                    at.file, at.line, length, h));
}

/// How far up the water reaches on a patch, from its lowest to its highest node there [m]; 0: it is dry.
template <int Dim>
double depthAt(const State<Dim>& state, std::size_t patch, const Vec<Dim>& up) {
    int first = 0;  // of the patch's faces among all
    for (std::size_t k = 0; k < patch; ++k) first += static_cast<int>(state.mesh.patches[k].faces.size());
    const int last = first + static_cast<int>(state.mesh.patches[patch].faces.size());
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int node : cell)
            for (const int wall : state.nodes.wall[node]) {
                if (wall < first || wall >= last) continue;
                low = std::min(low, up.dot(state.nodes.x[node]));
                high = std::max(high, up.dot(state.nodes.x[node]));
            }
    return std::max(0.0, high - low);
}

template <int Dim>
void lookAtPistons(const Dictionary& conditions, const Problem<Dim>& problem, const State<Dim>& state,
                   std::vector<std::string>& found) {
    for (std::size_t k = 0; k < state.mesh.patches.size(); ++k) {
        const auto& motion = problem.conditions.motion[k];
        if (!motion || !motion->absorption()) continue;
        const Absorption& wall = *motion->absorption();
        const double depth = depthAt<Dim>(state, k, wall.up.template head<Dim>());
        if (std::abs(depth - wall.depth) <= 0.05 * wall.depth) continue;
        const auto& name = state.mesh.patches[k].name;
        const Location at = conditions.subDict(name).subDict("motion").where("absorb");
        found.push_back(
            fmt::format("entry 'absorb' in {}:{}: the water before '{}' is {:.3g} m deep, not {:.3g} m: the "
                        "wall takes the difference for a wave",
                        at.file, at.line, name, depth, wall.depth));
    }
}

}  // namespace

template <int Dim>
std::vector<std::string> doubtsAboutWaves(const Dictionary& conditions, const Problem<Dim>& problem,
                                          const State<Dim>& state) {
    std::vector<std::string> found;
    lookAt(conditions, meshSizeOfFluid<Dim>(state), found);
    lookAtPistons<Dim>(conditions, problem, state, found);
    return found;
}

template std::vector<std::string> doubtsAboutWaves<2>(const Dictionary&, const Problem<2>&, const State<2>&);
template std::vector<std::string> doubtsAboutWaves<3>(const Dictionary&, const Problem<3>&, const State<3>&);

}  // namespace pfem
