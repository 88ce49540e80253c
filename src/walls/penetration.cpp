#include "walls/penetration.hpp"

#include <limits>
#include <tuple>

#include "mesh/distance.hpp"
#include "mesh/locator.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

using Edge = Face<2>;

/// Bins of faces for fast "which faces are near" questions.
class FaceBins {
public:
    FaceBins(const Points<2>& x, const std::vector<Edge>& faces, double width) : width_(width) {
        if (faces.empty()) return;
        low_ = Vec<2>::Constant(std::numeric_limits<double>::max());
        Vec<2> high = -low_;
        for (const auto& f : faces)
            for (int node : f) {
                low_ = low_.cwiseMin(x[node]);
                high = high.cwiseMax(x[node]);
            }
        low_ -= Vec<2>::Constant(width);
        n_[0] = static_cast<int>((high[0] - low_[0]) / width) + 2;
        n_[1] = static_cast<int>((high[1] - low_[1]) / width) + 2;
        bins_.resize(static_cast<std::size_t>(n_[0]) * n_[1]);
        for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
            const Vec<2> a = x[faces[f][0]].cwiseMin(x[faces[f][1]]);
            const Vec<2> b = x[faces[f][0]].cwiseMax(x[faces[f][1]]);
            for (int i = index(a, 0) - 1; i <= index(b, 0) + 1; ++i)
                for (int j = index(a, 1) - 1; j <= index(b, 1) + 1; ++j)
                    if (i >= 0 && j >= 0 && i < n_[0] && j < n_[1]) bins_[i * n_[1] + j].push_back(f);
        }
    }

    const std::vector<int>& near(const Vec<2>& point) const {
        static const std::vector<int> none;
        if (bins_.empty()) return none;
        const int i = index(point, 0), j = index(point, 1);
        return i < 0 || j < 0 || i >= n_[0] || j >= n_[1] ? none : bins_[i * n_[1] + j];
    }

private:
    int index(const Vec<2>& p, int d) const { return static_cast<int>(std::floor((p[d] - low_[d]) / width_)); }

    Vec<2> low_ = Vec<2>::Zero();
    double width_;
    int n_[2] = {0, 0};
    std::vector<std::vector<int>> bins_;
};

/// Put node i at `distance` off the face on the side of n and stop its motion against n.
void putBack(const Edge& face, const Vec<2>& n, double distance, int i, Nodes<2>& nodes) {
    const auto& [x, v] = std::tie(nodes.x, nodes.v);
    const double s = nearestWeight<2>(x[face[0]], x[face[1]], x[i]);
    nodes.x[i] = x[face[0]] + s * (x[face[1]] - x[face[0]]) + distance * n;
    const Vec<2> surface = (1 - s) * v[face[0]] + s * v[face[1]];
    const double inward = (v[i] - surface).dot(n);
    if (inward < 0) nodes.v[i] -= inward * n;
}

}  // namespace

template <>
int returnPenetrating<2>(const Topology<2>& topology, double distance, State<2>& state) {
    if (state.mesh.solid.nodes.empty()) return 0;
    Nodes<2>& nodes = state.nodes;
    std::vector<Edge> faces;
    for (const auto& face : boundaryFaces<2>(state.mesh.solid.nodes, topology.solid)) faces.push_back(face.nodes);
    double hMax = 0;
    for (double h : nodes.h) hMax = std::max(hMax, h);
    const FaceBins bins(nodes.x, faces, 2 * hMax);
    const Locator<2> solid(nodes.x, state.mesh.solid.nodes);

    int count = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        if (topology.held(i) || !solid.contains(nodes.x[i])) continue;
        int nearest = -1;
        double best = std::numeric_limits<double>::max();
        for (int f : bins.near(nodes.x[i])) {
            const double d = distanceToFace<2>(nodes.x, faces[f], nodes.x[i]);
            if (d < best) {
                best = d;
                nearest = f;
            }
        }
        if (nearest < 0) continue;
        const Vec<2> n = faceArea<2>(nodes.x, faces[nearest]).normalized();  // out of the solid
        putBack(faces[nearest], n, distance * nodes.h[i], i, nodes);
        ++count;
    }
    return count;
}

}  // namespace pfem
