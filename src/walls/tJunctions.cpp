#include "walls/tJunctions.hpp"

#include <cmath>
#include <utility>

#include "mesh/distance.hpp"
#include "mesh/simplex.hpp"
#include "walls/wallLine.hpp"

namespace pfem {

void standOnWalls(const Mesh<2>& mesh, const std::vector<bool>& isWall, Nodes<2>& nodes) {
    std::vector<Face<2>> faces;
    std::vector<int> index;  // as counted by Nodes::wall
    int count = 0;
    for (std::size_t k = 0; k < mesh.patches.size(); ++k)
        for (const auto& face : mesh.patches[k].faces) {
            if (isWall[k]) {
                faces.push_back(face);
                index.push_back(count);
            }
            ++count;
        }
    for (const auto& wall : faces)
        for (int corner : wall) {
            nodes.wall[corner] = -1;
            for (std::size_t w = 0; w < faces.size(); ++w) {
                const auto [a, b] = faces[w];
                if (a == corner || b == corner) continue;
                if (distanceToFace<2>(nodes.x, faces[w], nodes.x[corner]) < 1e-6 * nodes.h[corner])
                    nodes.wall[corner] = index[w];
            }
        }
}

bool leaveTJunctions(const Topology<2>& topology, const Points<2>& v, State<2>& state) {
    Nodes<2>& nodes = state.nodes;
    const int n = nodes.size();
    std::vector<int> heir(n, -1);
    for (int i = 0; i < n; ++i) {
        if (!topology.corner[i] || !topology.wet(i) || nodes.wall[i] < 0) continue;
        const Face<2>& floor = topology.walls[nodes.wall[i]].nodes;
        const Vec<2> inward = -faceArea<2>(nodes.x, floor).normalized(), relative = v[i] - v[floor[0]];
        if (inward.dot(relative) <= 1e-6 * relative.norm()) continue;
        heir[i] = nodes.size();
        nodes.append(Nodes<2>(nodes), i);
        nodes.id.back() = state.nextId++;
        nodes.X.back() = nodes.x[i];
        nodes.v.back() = v[floor[0]];
        nodes.a.back().setZero();
        nodes.lostVolume[i] = 0;  // goes with the water
        for (auto& [cause, amounts] : state.ledger.fields()) amounts.push_back(std::exchange(amounts[i], 0.0));
    }
    for (auto& cell : state.mesh.fluid.nodes)
        for (int& node : cell)
            if (heir[node] >= 0) node = heir[node];
    return nodes.size() > n;
}

std::vector<int> looseEnds(const Mesh<2>& mesh, const std::vector<bool>& isWall, const Nodes<2>& nodes) {
    std::vector<int> uses(nodes.x.size(), 0);
    for (const auto& patch : mesh.patches)
        for (const auto& face : patch.faces)
            for (int node : face) ++uses[node];
    std::vector<int> ends;
    for (std::size_t k = 0; k < mesh.patches.size(); ++k)
        for (const auto& face : mesh.patches[k].faces) {
            if (!isWall[k]) continue;
            const Vec<2> along = (nodes.x[face[1]] - nodes.x[face[0]]).normalized();
            for (int node : face) {
                const bool gliding = std::abs(along.dot(nodes.v[node])) > 1e-6 * nodes.v[node].norm();
                if (uses[node] == 1 && nodes.wall[node] < 0 && gliding) ends.push_back(node);
            }
        }
    return ends;
}

TJunctions::TJunctions(const Topology<2>& topology, const Nodes<2>& nodes) {
    for (int i = 0; i < nodes.size(); ++i)
        if (topology.corner[i] && nodes.wall[i] >= 0) junctions_.push_back(i);
}

double TJunctions::stop(const Topology<2>& topology, int w, const Points<2>& xOld, const Nodes<2>& nodes, int i,
                        double s) const {
    for (int foot : junctions_) {
        if (nodes.wall[foot] != w) continue;
        const WallLine now(nodes.x, topology.walls[w].nodes), before(xOld, topology.walls[w].nodes);
        const double place = now.along(nodes.x[foot]);
        const bool wasAfter = before.along(xOld[i]) >= before.along(xOld[foot]);
        if ((s >= place) != wasAfter) s = place;
    }
    return s;
}

}  // namespace pfem
