#include "functions/sensorMean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "functions/discIntegral.hpp"
#include "functions/wetFaces.hpp"
#include "mesh/nearestOnFace.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
std::pair<SensorAnchor<Dim>, double> fixSensor(const State<Dim>& initial, const std::vector<PatchKind>& kinds,
                                               const Vec<Dim>& point) {
    std::pair<SensorAnchor<Dim>, double> best{{}, std::numeric_limits<double>::infinity()};
    const auto consider = [&](const Face<Dim>& face, const Points<Dim>& x, bool onSolid) {
        const Vec<Dim> weights = nearestWeights<Dim>(x, face, point);
        SensorAnchor<Dim> anchor{{}, weights, onSolid};
        Vec<Dim> foot = Vec<Dim>::Zero();
        for (int k = 0; k < Dim; ++k) {
            foot += weights[k] * x[face[k]];
            anchor.ids[k] = initial.nodes.id[face[k]];
        }
        const double distance = (foot - point).norm();
        if (distance < best.second) best = {anchor, distance};
    };
    for (std::size_t k = 0; k < initial.mesh.patches.size(); ++k)
        if (isWall(kinds[k]))
            for (const auto& face : initial.mesh.patches[k].faces) consider(face, initial.nodes.x, false);
    const auto& solid = initial.mesh.solid.nodes;
    for (const auto& face : boundaryFaces<Dim>(solid, nodeToCells<Dim>(solid, initial.nodes.size())))
        consider(face.nodes, initial.nodes.X, true);
    return best;
}

template <int Dim>
std::pair<Face<Dim>, Vec<Dim>> placeOf(const SensorAnchor<Dim>& anchor, const Nodes<Dim>& nodes) {
    Face<Dim> face{};
    Vec<Dim> centre = Vec<Dim>::Zero();
    for (std::size_t k = 0; k < Dim; ++k) {
        face[k] =
            static_cast<int>(std::lower_bound(nodes.id.begin(), nodes.id.end(), anchor.ids[k]) - nodes.id.begin());
        centre += anchor.weights[static_cast<Eigen::Index>(k)] * nodes.x[face[k]];
    }
    return {face, centre};
}

namespace {

/// Antiderivatives of the weight w(s) and of s w(s); w integrates to 1 over the sensor, |s| <= R.
struct Weight {
    double R;
    bool disc;

    double zeroth(double s) const {
        if (!disc) return s / (2 * R);
        return (s * std::sqrt(std::max(0.0, R * R - s * s)) + R * R * std::asin(std::clamp(s / R, -1.0, 1.0))) /
               (M_PI * R * R);
    }
    double first(double s) const {
        if (!disc) return s * s / (4 * R);
        return -2 / (3 * M_PI * R * R) * std::pow(std::max(0.0, R * R - s * s), 1.5);
    }
};

/// Where a sensor is: its centre, the normal out of the fluid, what it is fixed to.
template <int Dim>
struct SensorPlace {
    Vec<Dim> centre, normal;
    bool onSolid;
};

/// Of a line of wet faces.
SensorReading readFaces(const Nodes<2>& nodes, const std::vector<WetFace<2>>& faces, const SensorPlace<2>& place,
                        const Weight& weight) {
    const auto& [centre, normal, onSolid] = place;
    const Vec<2> along(-normal[1], normal[0]);
    SensorReading reading;
    for (const auto& wet : faces) {
        if ((wet.solid >= 0) != onSolid) continue;
        const Vec<2> a = nodes.x[wet.nodes[0]] - centre, b = nodes.x[wet.nodes[1]] - centre;
        const double sa = a.dot(along), sb = b.dot(along);
        const double low = std::max(std::min(sa, sb), -weight.R), high = std::min(std::max(sa, sb), weight.R);
        if (!(low < high) || faceArea<2>(nodes.x, wet.nodes).normalized().dot(normal) < 0.7) continue;
        const auto at = [&](double s, double fa, double fb) { return fa + (fb - fa) * (s - sa) / (sb - sa); };
        const double height = at(0.5 * (low + high), a.dot(normal), b.dot(normal));
        if (std::abs(height) > weight.R) continue;  // of another wall
        const double slope = (nodes.p[wet.nodes[1]] - nodes.p[wet.nodes[0]]) / (sb - sa);
        const double p0 = nodes.p[wet.nodes[0]] - slope * sa;
        const double part = weight.zeroth(high) - weight.zeroth(low);
        reading.wet += part;
        reading.p += p0 * part + slope * (weight.first(high) - weight.first(low));
    }
    return reading;
}

/// Weights of a triangle's corners at s.
Vec<3> weightsAt(const std::array<Vec<2>, 3>& corners, const Vec<2>& s) {
    const Vec<2> b = corners[1] - corners[0], c = corners[2] - corners[0], d = s - corners[0];
    const double area = b[0] * c[1] - b[1] * c[0];
    const double v = (d[0] * c[1] - d[1] * c[0]) / area, w = (b[0] * d[1] - b[1] * d[0]) / area;
    return {1 - v - w, v, w};
}

/// Of the triangles around, projected onto the disc's plane: p = p0 + g . s there.
SensorReading readFaces(const Nodes<3>& nodes, const std::vector<WetFace<3>>& faces, const SensorPlace<3>& place,
                        const Weight& weight) {
    Tensor<3> axes;  // two along the plane, the normal
    axes.col(2) = place.normal;
    axes.col(0) = place.normal.unitOrthogonal();
    axes.col(1) = place.normal.cross(Vec<3>(axes.col(0)));
    SensorReading reading;
    for (const auto& wet : faces) {
        if ((wet.solid >= 0) != place.onSolid) continue;
        if (faceArea<3>(nodes.x, wet.nodes).normalized().dot(place.normal) < 0.7) continue;
        std::array<Vec<2>, 3> corners;
        Vec<3> height, p;
        for (int k = 0; k < 3; ++k) {
            const Vec<3> s = axes.transpose() * (nodes.x[wet.nodes[k]] - place.centre);
            corners[k] = s.head<2>();
            height[k] = s[2];
            p[k] = nodes.p[wet.nodes[k]];
        }
        const AreaMoments part = discPart(corners, weight.R);
        if (!(part.area > 1e-12 * weight.R * weight.R)) continue;
        const Vec<3> weights = weightsAt(corners, part.moment / part.area);
        if (std::abs(height.dot(weights)) > weight.R) continue;  // of another wall
        reading.wet += part.area / (M_PI * weight.R * weight.R);
        reading.p += p.dot(weights) * part.area / (M_PI * weight.R * weight.R);
    }
    return reading;
}

}  // namespace

template <int Dim>
SensorReading readSensor(const State<Dim>& state, const Topology<Dim>& topology, const SensorAnchor<Dim>& anchor,
                         double width, bool disc) {
    const auto [face, centre] = placeOf<Dim>(anchor, state.nodes);
    // out of the fluid: walls have it on their left, solids have themselves on the left
    const Vec<Dim> normal = (anchor.onSolid ? -1 : 1) * faceArea<Dim>(state.nodes.x, face).normalized();
    return readFaces(state.nodes, wetFaces<Dim>(state, topology), SensorPlace<Dim>{centre, normal, anchor.onSolid},
                     {0.5 * width, disc});
}

#define PFEM_INSTANTIATE(D)                                                                                  \
    template std::pair<SensorAnchor<D>, double> fixSensor<D>(const State<D>&, const std::vector<PatchKind>&, \
                                                             const Vec<D>&);                                 \
    template std::pair<Face<D>, Vec<D>> placeOf<D>(const SensorAnchor<D>&, const Nodes<D>&);                 \
    template SensorReading readSensor<D>(const State<D>&, const Topology<D>&, const SensorAnchor<D>&, double, bool);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
