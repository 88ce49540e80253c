#include "solver/checkWaves.hpp"

#include <fmt/format.h>

#include <cmath>

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

}  // namespace

template <int Dim>
std::vector<std::string> doubtsAboutWaves(const Dictionary& conditions, const State<Dim>& state) {
    std::vector<std::string> found;
    lookAt(conditions, meshSizeOfFluid<Dim>(state), found);
    return found;
}

template std::vector<std::string> doubtsAboutWaves<2>(const Dictionary&, const State<2>&);
template std::vector<std::string> doubtsAboutWaves<3>(const Dictionary&, const State<3>&);

}  // namespace pfem
