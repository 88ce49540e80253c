#include "mesher/space/spaceReport.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <queue>

#include "mesh/adjacency.hpp"
#include "mesh/simplex.hpp"
#include "mesher/space/checkSurface.hpp"

namespace pfem {

namespace {

/// Smallest angle between two faces [degrees].
double leastAngle(const Points<3>& x, const Simplex<3>& s) {
    double least = 180;
    std::array<Vec<3>, 4> n;
    for (int k = 0; k < 4; ++k) n[k] = faceArea<3>(x, oppositeFace<3>(s, k)).normalized();
    for (int k = 0; k < 4; ++k)
        for (int l = k + 1; l < 4; ++l)
            least = std::min(least, std::acos(std::clamp(-n[k].dot(n[l]), -1.0, 1.0)) * 180 / std::numbers::pi);
    return least;
}

/// About how many of the solid tetrahedra first .. last-1 are across their body where it is thickest: of a slender
/// plate its thickness is twice its volume by its surface; of a bar twice the way from an inner node to the surface.
double tetrahedraAcross(const State<3>& state, int first, int last, double h) {
    const auto& all = state.mesh.solid.nodes;
    const std::vector<Simplex<3>> cells(all.begin() + first, all.begin() + last);
    const auto around = nodeToCells<3>(cells, state.nodes.size());
    double volume = 0, surface = 0;
    for (const auto& s : cells) volume += simplexMeasure<3>(state.nodes.x, s);
    using Way = std::pair<double, int>;
    std::vector<double> way(state.nodes.size(), std::numeric_limits<double>::infinity());
    std::priority_queue<Way, std::vector<Way>, std::greater<>> open;
    for (const auto& face : boundaryFaces<3>(cells, around)) {
        surface += faceArea<3>(state.nodes.x, face.nodes).norm();
        for (const int i : face.nodes) open.emplace(way[i] = 0, i);
    }
    double farthest = 0;
    while (!open.empty()) {  // Dijkstra along the edges
        const auto [length, i] = open.top();
        open.pop();
        if (length > way[i]) continue;
        farthest = length;
        for (int c = around.start[i]; c < around.start[i + 1]; ++c)
            for (const int j : cells[around.cell[c]]) {
                const double there = length + (state.nodes.x[i] - state.nodes.x[j]).norm();
                if (there < way[j]) open.emplace(way[j] = there, j);
            }
    }
    return std::max(2 * volume / surface, 2 * farthest) / h;
}

/// Part of the volume of the fluid tetrahedra first .. last-1 that has all nodes on walls. Along edges of a tank there
/// are always some.
double partOnWalls(const State<3>& state, int first, int last) {
    double sum = 0, onWalls = 0;
    for (int c = first; c < last; ++c) {
        const auto& s = state.mesh.fluid.nodes[c];
        const double volume = simplexMeasure<3>(state.nodes.x, s);
        sum += volume;
        if (std::all_of(s.begin(), s.end(), [&](int i) { return isSupported(state.nodes.wall[i]); })) onWalls += volume;
    }
    return onWalls / sum;
}

std::string warningsOf(const SpaceDescription& description, const SpaceMeshResult& result) {
    std::string text;
    for (const auto& warning : result.warnings) text += "--> PFEM Warning: " + warning + "\n";
    for (std::size_t b = 0; b < description.bodies.size(); ++b) {
        const auto& body = description.bodies[b];
        const auto& meshed = result.bodies[b];
        const auto& mesh = result.state.mesh;
        const auto q = tetraQuality(result.state.nodes, body.type == BodyType::fluid ? mesh.fluid : mesh.solid,
                                    meshed.first, meshed.last);
        if (q.minAngle < 5)
            text += fmt::format("--> PFEM Warning: '{}' has two faces at {:.1f} degrees near {}\n", body.name,
                                q.minAngle, placeOf(q.worst));
        if (q.count == 0) continue;
        if (body.type == BodyType::fluid) {
            const double part = partOnWalls(result.state, meshed.first, meshed.last);
            if (part > 0.5)
                text += fmt::format(
                    "--> PFEM Warning: {:.0f} % of '{}' is in tetrahedra with all nodes on walls: the channel is too "
                    "narrow for this meshSize\n",
                    100 * part, body.name);
            continue;
        }
        const double across = tetrahedraAcross(result.state, meshed.first, meshed.last, meshed.size);
        if (across < 3)
            text +=
                fmt::format("--> PFEM Warning: solid '{}' has only about {:.1f} tetrahedra across; bending needs 4\n",
                            body.name, across);
    }
    return text;
}

}  // namespace

TetraQuality tetraQuality(const Nodes<3>& nodes, const Cells<3>& cells, int first, int last) {
    TetraQuality quality;
    quality.count = last - first;
    if (quality.count == 0) return quality;
    std::vector<double> edges;
    for (int c = first; c < last; ++c) {
        const auto& s = cells.nodes[c];
        const double volume = simplexMeasure<3>(nodes.x, s), angle = leastAngle(nodes.x, s);
        double h = 0;
        for (int k = 0; k < 4; ++k) {
            h += nodes.h[s[k]] / 4;
            for (int l = k + 1; l < 4; ++l)
                edges.push_back(2 * (nodes.x[s[k]] - nodes.x[s[l]]).norm() / (nodes.h[s[k]] + nodes.h[s[l]]));
        }
        quality.volume += volume;
        quality.slivers += volume < 1e-2 * h * h * h;
        quality.meanMinAngle += angle / quality.count;
        if (angle < quality.minAngle) quality.minAngle = angle, quality.worst = simplexCentroid<3>(nodes.x, s);
    }
    std::sort(edges.begin(), edges.end());
    quality.shortest = edges.front();
    quality.median = edges[edges.size() / 2];
    quality.longest = edges.back();
    return quality;
}

std::string spaceReport(const SpaceDescription& description, const SpaceMeshResult& result) {
    const auto& state = result.state;
    std::string text = fmt::format("{:<16s} {:<6s} {:<12s} {:>10s} {:>12s} {:>10s} {:>6s} {:>6s} {:>8s}   {}\n", "body",
                                   "type", "material", "tetrahedra", "volume [m3]", "size [m]", "min", "mean",
                                   "slivers", "edge/size: min median max");
    for (std::size_t b = 0; b < description.bodies.size(); ++b) {
        const auto& body = description.bodies[b];
        const auto& meshed = result.bodies[b];
        const bool fluid = body.type == BodyType::fluid;
        const auto q =
            tetraQuality(state.nodes, fluid ? state.mesh.fluid : state.mesh.solid, meshed.first, meshed.last);
        text += fmt::format(
            "{:<16s} {:<6s} {:<12s} {:>10d} {:>12.6g} {:>10g} {:>6.1f} {:>6.1f} {:>8d}   {:.2f} {:.2f} {:.2f}\n",
            body.name, fluid ? "fluid" : "solid", body.material, q.count, q.volume, meshed.size, q.minAngle,
            q.meanMinAngle, q.slivers, q.shortest, q.median, q.longest);
    }
    text +=
        "(min, mean: smallest angle between faces of a tetrahedron in degrees, 70.5 is perfect; slivers: volume "
        "below 0.01 size^3)\n\n";
    std::string warnings = warningsOf(description, result);
    for (const auto& patch : state.mesh.patches) {
        double area = 0;
        for (const auto& face : patch.faces) area += faceArea<3>(state.nodes.x, face).norm();
        text += fmt::format("patch {:<16s} {:>7d} faces {:>12.6g} m2\n", patch.name, patch.faces.size(), area);
        if (patch.faces.empty()) warnings += fmt::format("--> PFEM Warning: patch '{}' has no face\n", patch.name);
    }
    text += fmt::format("nodes {}, fluid tetrahedra {}, solid tetrahedra {}\n", state.nodes.size(),
                        state.mesh.fluid.size(), state.mesh.solid.size());
    return text + warnings;
}

}  // namespace pfem
