#include "mesher/meshReport.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pfem {

TriangleQuality triangleQuality(const Nodes<2>& nodes, const Cells<2>& cells, int first, int last) {
    TriangleQuality quality;
    quality.count = last - first;
    if (quality.count == 0) return quality;
    std::vector<double> edges;
    for (int c = first; c < last; ++c) {
        double least = 180;
        for (int k = 0; k < 3; ++k) {
            const int i = cells.nodes[c][k], j = cells.nodes[c][(k + 1) % 3], l = cells.nodes[c][(k + 2) % 3];
            const Vec<2> u = nodes.x[j] - nodes.x[i], w = nodes.x[l] - nodes.x[i];
            const double cross = u.x() * w.y() - u.y() * w.x();
            least = std::min(least, std::atan2(cross, u.dot(w)) * 180 / std::numbers::pi);
            edges.push_back(2 * u.norm() / (nodes.h[i] + nodes.h[j]));
            if (k == 0) quality.area += 0.5 * cross;
        }
        if (least < quality.minAngle) {
            quality.minAngle = least;
            quality.worst = nodes.x[cells.nodes[c][0]];
        }
        quality.meanMinAngle += least / quality.count;
    }
    std::sort(edges.begin(), edges.end());
    quality.shortest = edges.front();
    quality.median = edges[edges.size() / 2];
    quality.longest = edges.back();
    return quality;
}

std::vector<int> wallTriangles(const State<2>& state) {
    std::vector<bool> wall(state.nodes.size(), false);
    for (int i = 0; i < state.nodes.size(); ++i) wall[i] = isSupported(state.nodes.wall[i]);
    std::vector<int> found;
    for (int c = 0; c < state.mesh.fluid.size(); ++c) {
        const auto& t = state.mesh.fluid.nodes[c];
        if (wall[t[0]] && wall[t[1]] && wall[t[2]]) found.push_back(c);
    }
    return found;
}

std::string meshReport(const MeshDescription& description, const MeshResult& result) {
    const auto& state = result.state;
    std::string text =
        fmt::format("{:<16s} {:<6s} {:<12s} {:>9s} {:>12s} {:>10s} {:>6s} {:>6s}   {}\n", "body", "type", "material",
                    "triangles", "area [m2]", "size [m]", "min", "mean", "edge/size: min median max");
    std::string warnings;
    for (const auto& warning : result.warnings) warnings += "--> PFEM Warning: " + warning + "\n";
    for (std::size_t b = 0; b < description.bodies.size(); ++b) {
        const Body& body = description.bodies[b];
        const bool fluid = body.type == BodyType::fluid;
        const auto& meshed = result.bodies[b];
        const auto q =
            triangleQuality(state.nodes, fluid ? state.mesh.fluid : state.mesh.solid, meshed.first, meshed.last);
        const double h = meshed.size;
        text +=
            fmt::format("{:<16s} {:<6s} {:<12s} {:>9d} {:>12.6g} {:>10g} {:>6.1f} {:>6.1f}   {:.2f} {:.2f} {:.2f}\n",
                        body.name, fluid ? "fluid" : "solid", body.material, q.count, q.area, h, q.minAngle,
                        q.meanMinAngle, q.shortest, q.median, q.longest);
        if (q.minAngle < 20)
            warnings += fmt::format("--> PFEM Warning: '{}' has an angle of {:.1f} degrees near ({:g} {:g})\n",
                                    body.name, q.minAngle, q.worst.x(), q.worst.y());
        // a slender body's thickness is about twice its area by its perimeter
        const double across = 2 * meshed.area / meshed.perimeter / h;
        if (!fluid && body.pattern == Pattern::unstructured && across < 3)
            warnings += fmt::format(
                "--> PFEM Warning: solid '{}' has only about {:.1f} triangles across; bending "
                "needs 4\n",
                body.name, across);
    }
    text += "(min, mean: smallest angle of a triangle in degrees; 60 is perfect)\n\n";
    for (const auto& patch : state.mesh.patches) {
        double length = 0;
        for (const auto& [a, b] : patch.faces) length += (state.nodes.x[a] - state.nodes.x[b]).norm();
        text += fmt::format("patch {:<16s} {:>7d} faces {:>12.6g} m\n", patch.name, patch.faces.size(), length);
        if (patch.faces.empty()) warnings += fmt::format("--> PFEM Warning: patch '{}' has no face\n", patch.name);
    }
    const auto stuck = wallTriangles(state);
    if (!stuck.empty()) {
        const auto& x = state.nodes.x[state.mesh.fluid.nodes[stuck.front()][0]];
        warnings += fmt::format(
            "--> PFEM Warning: {} fluid triangles have all nodes on walls, the first near ({:g} "
            "{:g}): the channel is too narrow for this meshSize\n",
            stuck.size(), x.x(), x.y());
    }
    text += fmt::format("nodes {}, fluid triangles {}, solid triangles {}\n", state.nodes.size(),
                        state.mesh.fluid.size(), state.mesh.solid.size());
    return text + warnings;
}

}  // namespace pfem
