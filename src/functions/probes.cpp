#include "functions/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "base/error.hpp"
#include "functions/sampling.hpp"
#include "functions/sensors.hpp"

namespace pfem {

namespace {

/// In a cell or, where a round or slanted side is a chord of its cells, by this part of one outside.
constexpr double beside = 0.1;

template <int Dim>
std::optional<WeightedNodes<Dim>> nearestPlace(const State<Dim>& initial, Region region, const Vec<Dim>& point,
                                               double tolerance) {
    return region == Region::solid ? locate<Dim>(initial.mesh.solid, initial.nodes.X, point, tolerance)
                                   : locate<Dim>(initial.mesh.fluid, initial.nodes.x, point, tolerance);
}

}  // namespace

template <int Dim>
Probes<Dim>::Probes(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    fields_ = nodalFields<Dim>(dict, dict.get<std::vector<std::string>>("fields"));
    const std::string key = dict.found("points") ? "points" : "probeLocations";
    points_ = dict.get<std::vector<Eigen::Vector3d>>(key);
    if (points_.empty()) dict.fatal(key, "no probe locations");
    warnOutOfPlane<Dim>(dict, key, points_);
    fixed_ = dict.get("fixedLocations", true);
    dict.found("interpolationScheme");  // always linear in the triangle
    dict.found("includeOutOfBounds");   // always
}

/// Attach the probes, write the headers.
template <int Dim>
void Probes<Dim>::start(const State<Dim>& state) {
    std::vector<bool> found;
    if (!fixed_) {
        const State<Dim> initial = initialState(context_.root, state);
        for (const auto& point : points_) anchors_.push_back(attach(initial, point.head<Dim>()));
        for (const auto& anchor : anchors_) found.push_back(anchor.has_value());
        warnOfNowhere(found);
    } else {
        for (const auto& point : points_)
            found.push_back(locate<Dim>(state.mesh.fluid, state.nodes.x, point.head<Dim>()) ||
                            locate<Dim>(state.mesh.solid, state.nodes.x, point.head<Dim>()));
    }
    tables_.clear();
    for (const auto& field : fields_) tables_.push_back(sensorTable(context_, field.name, "Probe", points_, found));
}

template <int Dim>
void Probes<Dim>::execute(const State<Dim>& state) {
    if (tables_.size() != fields_.size()) throw InternalError("probes: execute() before start()");
    std::vector<Samples<Dim>> samples(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (fixed_)
            samples[i] = sampleAt<Dim>(state, points_[i].head<Dim>());
        else if (anchors_[i])
            (anchors_[i]->region == Region::solid ? samples[i].inSolid : samples[i].inFluid) =
                follow(state, *anchors_[i]);
    }
    for (std::size_t f = 0; f < fields_.size(); ++f) {
        const NodalField<Dim>& field = fields_[f];
        Table& table = tables_[f];
        std::vector<std::string> row{table.time(state.time.value)};
        for (const auto& at : samples) {
            const auto value = sampledValue<Dim>(field, state.nodes, at, dry);
            row.push_back(field.components == 1 ? table.number(value[0]) : table.tuple(value));
        }
        table.row(row);
    }
}

template <int Dim>
std::optional<Anchor<Dim>> Probes<Dim>::attach(const State<Dim>& initial, const Vec<Dim>& point) const {
    for (const double tolerance : {1e-6, beside})
        for (const Region region : {Region::solid, Region::fluid}) {
            const Sample at = nearestPlace<Dim>(initial, region, point, tolerance);
            if (!at) continue;
            Anchor<Dim> anchor;
            anchor.weights = at->weights;
            anchor.region = region;
            for (std::size_t i = 0; i <= Dim; ++i) anchor.ids[i] = initial.nodes.id[at->nodes[i]];
            return anchor;
        }
    return {};
}

template <int Dim>
void Probes<Dim>::warnOfNowhere(const std::vector<bool>& found) const {
    for (std::size_t i = 0; i < points_.size(); ++i)
        if (!found[i])
            std::cerr << fmt::format(
                "--> PFEM Warning: probe {} of function '{}', ({:g} {:g} {:g}), is in no material at the first time: "
                "it "
                "has no values\n",
                i, context_.name, points_[i][0], points_[i][1], points_[i][2]);
}

/// Nothing when one of the nodes has been removed.
template <int Dim>
typename Probes<Dim>::Sample Probes<Dim>::follow(const State<Dim>& state, const Anchor<Dim>& anchor) const {
    const auto& ids = state.nodes.id;
    WeightedNodes<Dim> at;
    at.weights = anchor.weights;
    for (std::size_t i = 0; i <= Dim; ++i) {
        const auto found = std::lower_bound(ids.begin(), ids.end(), anchor.ids[i]);
        if (found == ids.end() || *found != anchor.ids[i]) return {};
        at.nodes[i] = static_cast<int>(found - ids.begin());
    }
    return at;
}

#define PFEM_INSTANTIATE(D) template class Probes<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
