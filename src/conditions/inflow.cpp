#include "conditions/inflow.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// Sticks the node to a no-slip wall?
template <int Dim>
bool sticks(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, int node) {
    for (const int wall : topology.supports[node])
        if (wall >= 0 && !topology.isOpening(wall) &&
            conditions.type[topology.walls[wall].patch]->wet == Constraint::fixed)
            return true;
    return false;
}

/// The wall faces of each inlet; of other patches none.
template <int Dim>
std::vector<std::vector<int>> facesOfInlets(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology) {
    std::vector<std::vector<int>> faces(conditions.inlet.size());
    for (int w = 0; w < static_cast<int>(topology.walls.size()); ++w)
        if (const int patch = topology.walls[w].patch; patch >= 0 && conditions.inlet[patch]) faces[patch].push_back(w);
    return faces;
}

/// Is x on an edge with which a smooth region of the faces of a patch ends?
template <int Dim>
bool isOnEdge(const Topology<Dim>& topology, const Points<Dim>& points, const std::vector<int>& faces,
              const Vec<Dim>& x, double near) {
    for (const int wall : faces) {
        const auto& face = topology.walls[wall];
        for (int k = 0; k < Dim; ++k) {
            if (face.bend[k] == Bend::smooth && face.next[k] >= 0 && topology.walls[face.next[k]].patch == face.patch)
                continue;
            if constexpr (Dim == 2) {
                if ((points[face.nodes[1 - k]] - x).norm() < near) return true;
            } else {
                const Vec<3>&a = points[face.nodes[(k + 1) % 3]], &b = points[face.nodes[(k + 2) % 3]];
                const double s = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                if ((a + s * (b - a) - x).norm() < near) return true;
            }
        }
    }
    return false;
}

/// 4 s (1 - s), s from 0 to 1 between the ends of the patch along its first face.
template <int Dim>
std::function<double(const Vec<Dim>&)> parabola(const std::vector<Face<Dim>>& faces, const Points<Dim>& x) {
    const Vec<Dim>& origin = x[faces[0][0]];
    const Vec<Dim> along = (x[faces[0][1]] - origin).normalized();
    double low = 0, high = 0;
    for (const auto& face : faces)
        for (const int node : face) {
            low = std::min(low, along.dot(x[node] - origin));
            high = std::max(high, along.dot(x[node] - origin));
        }
    return [=](const Vec<Dim>& place) {
        const double s = (along.dot(place - origin) - low) / (high - low);
        return 4 * s * (1 - s);
    };
}

/// Wet area of an inlet, between periodic sides. Faces that reach over its edge, onto a wall that goes on smoothly, are
/// not of it.
template <int Dim>
double wetArea(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Points<Dim>& x,
               const std::vector<Id>& id, int patch) {
    double area = 0;
    for (const auto& face : topology.faces)
        if (face.wall >= 0 && topology.walls[face.wall].patch == patch && isOwn(id, face.nodes) &&
            std::all_of(face.nodes.begin(), face.nodes.end(),
                        [&](int i) { return inletOf<Dim>(conditions, topology, i) == patch; }))
            area += faceArea<Dim>(x, face.nodes).norm();
    return area;
}

}  // namespace

template <int Dim>
InletSpread<Dim> inletSpread(const Inlet& inlet, const std::vector<Face<Dim>>& faces, const Points<Dim>& x, double t) {
    InletSpread<Dim> spread;
    spread.direction = inlet.direction.template head<Dim>();
    if (inlet.direction.squaredNorm() == 0)  // of a wall's face the area points away from the fluid
        for (const auto& face : faces) spread.direction -= faceArea<Dim>(x, face);
    spread.direction.normalize();
    switch (inlet.profile) {
        case Inlet::Profile::uniform:
            spread.speed = [](const Vec<Dim>&) { return 1.0; };
            break;
        case Inlet::Profile::parabolic:
            spread.speed = parabola<Dim>(faces, x);
            break;
        case Inlet::Profile::expression:
            spread.speed = [formula = std::make_shared<Expression>(*inlet.shape), t](const Vec<Dim>& place) {
                return (*formula)({place[0], place[1], Dim == 3 ? place[Dim - 1] : 0, t});
            };
            break;
    }
    return spread;
}

template <int Dim>
int inletOf(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, int node) {
    if (!topology.onWall[node]) return -1;
    for (const int wall : topology.supports[node])
        if (wall >= 0 && conditions.inlet[topology.walls[wall].patch]) return topology.walls[wall].patch;
    return -1;
}

template <int Dim>
std::vector<int> lipNodes(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology,
                          const Nodes<Dim>& nodes) {
    std::vector<int> lips;
    if (!conditions.anyInlet()) return lips;
    const auto facesOf = facesOfInlets<Dim>(conditions, topology);
    for (int i = 0; i < topology.nNodes(); ++i) {
        const int patch = nSupports(topology.supports[i]) == 1 ? inletOf<Dim>(conditions, topology, i) : -1;
        if (patch >= 0 && isOnEdge<Dim>(topology, nodes.x, facesOf[patch], nodes.x[i], 1e-6 * nodes.h[i]))
            lips.push_back(i);
    }
    return lips;
}

template <int Dim>
Inflow<Dim> inflowOf(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Points<Dim>& x,
                     const Nodes<Dim>& nodes, double t0, double t1) {
    Inflow<Dim> inflow;
    if (!conditions.anyInlet()) return inflow;
    std::vector<int> patchOf(x.size(), -1);
    for (int i = 0; i < topology.nNodes(); ++i) patchOf[i] = inletOf<Dim>(conditions, topology, i);
    const auto facesOf = facesOfInlets<Dim>(conditions, topology);
    std::vector<RigidStep<Dim>> step(x.size());
    for (int k = 0; k < static_cast<int>(conditions.inlet.size()); ++k) {
        if (!conditions.inlet[k]) continue;
        const Inlet& inlet = *conditions.inlet[k];
        std::vector<Face<Dim>> faces;
        for (const int wall : facesOf[k]) faces.push_back(topology.walls[wall].nodes);
        const auto spread = inletSpread<Dim>(inlet, faces, x, t1);
        const Vec<Dim>& e = spread.direction;
        const auto speed = [&](int i) { return sticks<Dim>(conditions, topology, i) ? 0 : spread.speed(x[i]); };
        double swept = 0;  // per time, with c = 1
        for (const auto& face : topology.faces)
            if (face.kind == FaceKind::wall && isOwn(nodes.id, face.nodes))
                for (const int node : face.nodes)
                    if (patchOf[node] == k) swept -= speed(node) * e.dot(faceArea<Dim>(x, face.nodes)) / Dim;
        const double area = wetArea<Dim>(conditions, topology, x, nodes.id, k), rate = inlet.ofVolume ? 1 : area;
        if (area > 0) inflow.volume += inlet.during(t0, t1) * rate;
        const double factor = swept > 0 ? rate / swept : 0;
        for (int i = 0; i < topology.nNodes(); ++i) {
            if (patchOf[i] != k) continue;
            const Vec<Dim> unit = factor * speed(i) * e;
            step[i].from = x[i];
            step[i].to = x[i] + inlet.during(t0, t1) * unit;
            step[i].velocity = inlet.at(t1) * unit;
        }
    }
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (patchOf[i] < 0) continue;
        bool pinned = !topology.freeSurface[i] || sticks<Dim>(conditions, topology, i);
        for (const int wall : topology.supports[i])
            if (!pinned && wall >= 0 && topology.isOpening(wall))
                pinned = isOnEdge<Dim>(topology, x, facesOf[topology.walls[wall].patch], x[i], 1e-6 * nodes.h[i]);
        inflow.driven.push_back({i, step[i], pinned});
    }
    return inflow;
}

template <int Dim>
double inletRate(const BoundaryConditions<Dim>& conditions, const Period<Dim>& period, const State<Dim>& state,
                 double t) {
    constexpr double peak = 1.5;  // of a parabola over its mean
    double rate = 0;
    for (std::size_t k = 0; k < conditions.inlet.size(); ++k) {
        if (!conditions.inlet[k]) continue;
        const Inlet& inlet = *conditions.inlet[k];
        double area = 0, h = std::numeric_limits<double>::max();
        Eigen::AlignedBox<double, Dim> box;
        for (const auto& face : state.mesh.patches[k].faces) {
            area += faceArea<Dim>(state.nodes.x, face).norm();
            for (const int node : face) {
                h = std::min(h, state.nodes.h[node]);
                box.extend(state.nodes.x[node]);
            }
        }
        for (int d = 0; d < Dim; ++d)
            if (period.length[d] > 0) area *= std::min(1.0, period.length[d] / box.sizes()[d]);
        const double speed = std::abs(inlet.at(t)) / (inlet.ofVolume ? area : 1);
        rate = std::max(rate, (inlet.profile == Inlet::Profile::uniform ? 1 : peak) * speed / h);
    }
    return rate;
}

#define PFEM_INSTANTIATE(D)                                                                                      \
    template InletSpread<D> inletSpread<D>(const Inlet&, const std::vector<Face<D>>&, const Points<D>&, double); \
    template int inletOf<D>(const BoundaryConditions<D>&, const Topology<D>&, int);                              \
    template std::vector<int> lipNodes<D>(const BoundaryConditions<D>&, const Topology<D>&, const Nodes<D>&);    \
    template Inflow<D> inflowOf<D>(const BoundaryConditions<D>&, const Topology<D>&, const Points<D>&,           \
                                   const Nodes<D>&, double, double);                                             \
    template double inletRate<D>(const BoundaryConditions<D>&, const Period<D>&, const State<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
