#include "mesh/wallSupports.hpp"

#include <algorithm>

#include "mesh/distance.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

template <int Dim>
Bins<Dim> binsOver(const std::vector<Face<Dim>>& faces, const std::vector<int>& walls, const Points<Dim>& x) {
    Points<Dim> corners;
    for (const int w : walls)
        for (const int i : faces[w]) corners.push_back(x[i]);
    double extent = 0;
    for (const auto& p : corners) extent = std::max(extent, (p - corners.front()).cwiseAbs().maxCoeff());
    const double perAxis = std::clamp(std::sqrt(static_cast<double>(walls.size())), 1.0, 100.0);
    return Bins<Dim>(corners, 2 * extent / perAxis);
}

template <int Dim>
std::vector<Face<Dim>> allFaces(const std::vector<Patch<Dim>>& patches) {
    std::vector<Face<Dim>> faces;
    for (const auto& patch : patches) faces.insert(faces.end(), patch.faces.begin(), patch.faces.end());
    return faces;
}

template <int Dim>
std::vector<int> wallFaces(const std::vector<Patch<Dim>>& patches, const std::vector<bool>& isWall) {
    std::vector<int> walls;
    int number = 0;
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (std::size_t f = 0; f < patches[p].faces.size(); ++f, ++number)
            if (isWall[p]) walls.push_back(number);
    return walls;
}

}  // namespace

template <int Dim>
WallSupports<Dim>::WallSupports(const std::vector<Patch<Dim>>& patches, const std::vector<bool>& isWall,
                                const Points<Dim>& x, double tolerance)
    : x_(x),
      tolerance_(tolerance),
      faces_(allFaces<Dim>(patches)),
      walls_(wallFaces<Dim>(patches, isWall)),
      bins_(binsOver<Dim>(faces_, walls_, x)) {
    for (const int w : walls_) {
        Vec<Dim> low = x[faces_[w][0]], high = low;
        for (const int i : faces_[w]) low = low.cwiseMin(x[i]).eval(), high = high.cwiseMax(x[i]).eval();
        const Vec<Dim> slack = Vec<Dim>::Constant(tolerance);
        bins_.add(w, low - slack, high + slack);
    }
}

template <int Dim>
std::vector<int> WallSupports<Dim>::supportsOf(const Vec<Dim>& point) const {
    std::vector<int> found;
    bins_.forEachNear(point, tolerance_, [&](int w) {
        if (distanceToFace<Dim>(x_, faces_[w], point) <= tolerance_) found.push_back(w);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

template <int Dim>
std::vector<Vec<Dim>> WallSupports<Dim>::normalsAt(const Vec<Dim>& point) const {
    std::vector<Vec<Dim>> normals;
    for (const int w : supportsOf(point)) {
        const Vec<Dim> n = faceArea<Dim>(x_, faces_[w]).normalized();
        if (std::none_of(normals.begin(), normals.end(), [&](const Vec<Dim>& m) { return (m - n).norm() < 1e-6; }))
            normals.push_back(n);
    }
    return normals;
}

template <int Dim>
Vec<Dim> alongPlanes(Vec<Dim> v, const std::vector<Vec<Dim>>& normals) {
    std::vector<Vec<Dim>> basis;
    for (Vec<Dim> n : normals) {
        for (const auto& b : basis) n -= b.dot(n) * b;
        if (n.norm() < 1e-6) continue;
        basis.push_back(n.normalized());
        v -= basis.back().dot(v) * basis.back();
    }
    return v;
}

#define PFEM_INSTANTIATE(D)         \
    template class WallSupports<D>; \
    template Vec<D> alongPlanes<D>(Vec<D>, const std::vector<Vec<D>>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
