#include "walls/solidContact.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/bins.hpp"
#include "mesh/components.hpp"
#include "mesh/onFace.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// How far beyond the end of a face a node may be, in parts of the face: corner upon corner is contact. What has passed
/// its plane there is beside it, but for round-off: the line of a foot that turns on its edge sinks before the edge.
constexpr double beyondEnd = 0.01, besideEnd = 1e-6;

/// What stays between solids, in parts of h: nodes that coincide could not be triangulated with the fluid around them.
constexpr double clearance = 1e-3;

/// A face that something may meet, seen from outside.
template <int Dim>
struct Obstacle {
    Face<Dim> nodes;
    Vec<Dim> normal;
    int group;  // region of the walls; body of a solid, counted on
    bool solid;
};

/// Bodies: solid cells that hang together; per node its body, -1 for others.
template <int Dim>
std::vector<int> bodiesOfNodes(const Mesh<Dim>& mesh, int nNodes) {
    const auto root = components(mesh.solid.nodes, nNodes);
    std::vector<int> body(nNodes, -1);
    for (const auto& cell : mesh.solid.nodes)
        for (const int node : cell) body[node] = root[node];
    return body;
}

template <int Dim>
struct Scene {
    std::vector<Obstacle<Dim>> obstacles;
    std::vector<int> node;                      // that may meet them
    std::map<int, std::vector<int>> neighbour;  // of these, along their own surface
    std::vector<int> body;                      // per node of the mesh

    void addFace(const Face<Dim>& face, bool ofSolid) {
        for (const int i : face)
            for (const int j : face)
                if (i != j && (body[i] >= 0) == ofSolid) neighbour[i].push_back(j);
    }
};

template <int Dim>
Scene<Dim> sceneOf(const Mesh<Dim>& mesh, const Topology<Dim>& topology, const Nodes<Dim>& nodes) {
    Scene<Dim> scene;
    scene.body = bodiesOfNodes<Dim>(mesh, nodes.size());
    int regions = 0;
    for (const auto& wall : topology.walls) {
        if (wall.patch < 0 || topology.kinds[wall.patch] == PatchKind::skin) continue;
        scene.obstacles.push_back({wall.nodes, inwardNormal<Dim>(nodes.x, wall.nodes), wall.region, false});
        scene.addFace(wall.nodes, false);
        regions = std::max(regions, wall.region + 1);
    }
    for (const auto& face : topology.solidFaces) {
        const Vec<Dim> normal = faceArea<Dim>(nodes.x, face.nodes).normalized();
        scene.obstacles.push_back({face.nodes, normal, regions + scene.body[face.nodes[0]], true});
        scene.addFace(face.nodes, true);
    }
    for (const auto& [i, beside] : scene.neighbour)
        if (scene.body[i] >= 0 || topology.wallPoint[i]) scene.node.push_back(i);
    return scene;
}

/// Is the face none of the node's own, and does the node's own surface, wall or solid, go away from it on all sides?
/// Otherwise something beside the node meets the face first: no point of a floor meets the side of what slides there.
template <int Dim>
bool mayMeet(const Scene<Dim>& scene, const Points<Dim>& x, int i, const Obstacle<Dim>& obstacle) {
    if (scene.body[i] < 0 && !obstacle.solid) return false;
    if (std::find(obstacle.nodes.begin(), obstacle.nodes.end(), i) != obstacle.nodes.end()) return false;
    const double back = -std::sin(featureAngle * M_PI / 180);  // surfaces that touch may be bent
    const auto& beside = scene.neighbour.at(i);
    return std::all_of(beside.begin(), beside.end(), [&](int j) {
        const Vec<Dim> along = x[j] - x[i];
        return along.dot(obstacle.normal) > back * along.norm();
    });
}

/// Does the node lie behind a face of its own body since the beginning? Then the body is between them: near sharp edges
/// it is thinner than what a contact may enter.
template <int Dim>
bool seesItsBack(const Scene<Dim>& scene, const Points<Dim>& X, int i, const Obstacle<Dim>& obstacle) {
    if (!obstacle.solid || scene.body[i] != scene.body[obstacle.nodes[0]]) return false;
    constexpr double around = 1;  // in parts of the face
    return faceArea<Dim>(X, obstacle.nodes).dot(X[i] - X[obstacle.nodes[0]]) < 0 &&
           footWeights<Dim>(X, obstacle.nodes, X[i]).minCoeff() > -around;
}

template <int Dim>
ContactPair<Dim> pairOf(int i, const Obstacle<Dim>& obstacle, const Vec<Dim>& weights, double distance, double kept) {
    ContactPair<Dim> pair;
    pair.weight.emplace_back(i, 1.0);
    for (int k = 0; k < Dim; ++k) pair.weight.emplace_back(obstacle.nodes[k], -weights[k]);
    const Tensor<Dim> basis = basisAround<Dim>(obstacle.normal);  // the normal is the last
    pair.frame.col(0) = basis.col(Dim - 1);
    for (int k = 1; k < Dim; ++k) pair.frame.col(k) = basis.col(k - 1);
    pair.kept = kept;
    pair.gap = distance - kept;
    return pair;
}

/// Is the foot on the face, or before its end by less than the node may go along it in the step? One that has passed
/// the face's plane beyond the end is beside it.
template <int Dim>
bool isBefore(const Obstacle<Dim>& obstacle, const Vec<Dim>& weights, const ContactPair<Dim>& pair,
              const Nodes<Dim>& nodes, double dt) {
    const double beyond = -weights.minCoeff();
    if (beyond <= (pair.gap < 0 ? besideEnd : beyondEnd)) return true;
    const double size = (nodes.x[obstacle.nodes[1]] - nodes.x[obstacle.nodes[0]]).norm();
    const Vec<Dim> u = pair.relative(nodes.v);
    return pair.gap > 0 && (beyond - beyondEnd) * size < 2 * dt * u.template tail<Dim - 1>().norm();
}

/// Of faces of one group that look the same way the nearest counts; in a dent a node meets several.
template <int Dim>
void addOrReplace(int group, ContactPair<Dim> pair, std::vector<std::pair<int, ContactPair<Dim>>>& pairs) {
    constexpr double alike = 0.9999;
    for (auto& [other, known] : pairs) {
        if (other != group || known.frame.col(0).dot(pair.frame.col(0)) < alike) continue;
        if (std::abs(pair.gap) < std::abs(known.gap)) known = std::move(pair);
        return;
    }
    pairs.emplace_back(group, std::move(pair));
}

}  // namespace

template <int Dim>
std::vector<ContactPair<Dim>> contactPairs(const Problem<Dim>& problem, const Mesh<Dim>& mesh,
                                           const Topology<Dim>& topology, const Nodes<Dim>& nodes, double dt) {
    std::vector<ContactPair<Dim>> pairs;
    if (!problem.contact.on || mesh.solid.nodes.empty()) return pairs;
    const Scene<Dim> scene = sceneOf<Dim>(mesh, topology, nodes);
    double fastest = 0, size = 0;
    for (const int i : scene.node) {
        fastest = std::max(fastest, nodes.v[i].norm());
        if (scene.body[i] >= 0) size = std::max(size, nodes.h[i]);
    }
    const double fall = problem.gravity.norm() * dt * dt, farthest = 4 * dt * fastest + fall + 0.5 * size;
    Bins<Dim> bins(nodes.x, 2 * size);
    for (std::size_t k = 0; k < scene.obstacles.size(); ++k) {
        Vec<Dim> low = nodes.x[scene.obstacles[k].nodes[0]], high = low;
        for (const int i : scene.obstacles[k].nodes) {
            low = low.cwiseMin(nodes.x[i]).eval();
            high = high.cwiseMax(nodes.x[i]).eval();
        }
        bins.add(static_cast<int>(k), low, high);
    }
    for (const int i : scene.node) {
        std::vector<std::pair<int, ContactPair<Dim>>> own;  // and their groups
        bins.forEachNear(nodes.x[i], farthest, [&](int k) {
            const Obstacle<Dim>& obstacle = scene.obstacles[k];
            if (!mayMeet<Dim>(scene, nodes.x, i, obstacle)) return;
            const Vec<Dim> weights = footWeights<Dim>(nodes.x, obstacle.nodes, nodes.x[i]);
            if (weights.minCoeff() < -1) return;
            const double h = scene.body[i] >= 0 ? nodes.h[i] : nodes.h[obstacle.nodes[0]];
            const double between = obstacle.solid && scene.body[i] >= 0 ? clearance * h : 0;
            const double distance = obstacle.normal.dot(nodes.x[i] - nodes.x[obstacle.nodes[0]]);
            auto pair = pairOf<Dim>(i, obstacle, weights, distance, between);
            if (!isBefore<Dim>(obstacle, weights, pair, nodes, dt)) return;
            const double gap = pair.gap;
            const double approach = std::max(0.0, -pair.relative(nodes.v)[0]);
            const double mayClose = dt * std::max(3 * approach, 2 * fastest) + fall + 0.02 * h;  // others may push
            if (gap < -0.5 * h || gap > mayClose) return;
            if (gap < 0 && seesItsBack<Dim>(scene, nodes.X, i, obstacle)) return;
            addOrReplace<Dim>(obstacle.group, std::move(pair), own);
        });
        for (auto& [group, pair] : own) pairs.push_back(std::move(pair));
    }
    return pairs;
}

#define PFEM_INSTANTIATE(D)                                                                                     \
    template std::vector<ContactPair<D>> contactPairs<D>(const Problem<D>&, const Mesh<D>&, const Topology<D>&, \
                                                         const Nodes<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
