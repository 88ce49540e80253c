#include "walls/pinched.hpp"

#include <algorithm>

#include "mesh/bins.hpp"
#include "mesh/components.hpp"
#include "mesh/distance.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// A face that fluid cannot pass, the normal towards the fluid.
template <int Dim>
struct Side {
    Face<Dim> nodes;
    Vec<Dim> normal;
    int body;  // -1: walls
};

template <int Dim>
std::vector<Side<Dim>> sidesOf(const Topology<Dim>& topology, const State<Dim>& state) {
    const auto body = components(state.mesh.solid.nodes, state.nodes.size());
    std::vector<Side<Dim>> sides;
    for (const auto& face : topology.solidFaces)
        sides.push_back({face.nodes, faceArea<Dim>(state.nodes.x, face.nodes).normalized(), body[face.nodes[0]]});
    for (const auto& wall : topology.walls)
        if (wall.patch >= 0) sides.push_back({wall.nodes, inwardNormal<Dim>(state.nodes.x, wall.nodes), -1});
    return sides;
}

/// Does one of those look the other way and belong to something else?
template <int Dim>
bool closeOnEachOther(const std::vector<const Side<Dim>*>& near) {
    for (const Side<Dim>* a : near)
        for (const Side<Dim>* b : near)
            if (a->body >= 0 && a->body != b->body && a->normal.dot(b->normal) < -0.5) return true;
    return false;
}

}  // namespace

template <int Dim>
std::vector<int> pinchedNodes(const Topology<Dim>& topology, double reach, const State<Dim>& state) {
    const Points<Dim>& x = state.nodes.x;
    const auto& h = state.nodes.h;
    const auto sides = sidesOf<Dim>(topology, state);
    if (sides.empty() || sides[0].body < 0) return {};  // no solids
    const double size = *std::max_element(h.begin(), h.end());
    Bins<Dim> bins(x, 2 * size);
    for (std::size_t k = 0; k < sides.size(); ++k) {
        Vec<Dim> low = x[sides[k].nodes[0]], high = low;
        for (const int node : sides[k].nodes) {
            low = low.cwiseMin(x[node]).eval();
            high = high.cwiseMax(x[node]).eval();
        }
        bins.add(static_cast<int>(k), low, high);
    }
    std::vector<int> pinched;
    std::vector<const Side<Dim>*> near;
    for (int i = 0; i < state.nodes.size(); ++i) {
        if (!topology.ofFluid(i)) continue;
        near.clear();
        bins.forEachNear(x[i], reach * h[i], [&](int k) {
            if (distanceToFace<Dim>(x, sides[k].nodes, x[i]) < reach * h[i]) near.push_back(&sides[k]);
        });
        if (near.size() > 1 && closeOnEachOther<Dim>(near)) pinched.push_back(i);
    }
    return pinched;
}

template std::vector<int> pinchedNodes<2>(const Topology<2>&, double, const State<2>&);
template std::vector<int> pinchedNodes<3>(const Topology<3>&, double, const State<3>&);

}  // namespace pfem
