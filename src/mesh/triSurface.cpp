#include "mesh/triSurface.hpp"

#include <algorithm>

#include "mesh/simplex.hpp"

namespace pfem {

Vec<3> TriSurface::low() const {
    Vec<3> corner = x.front();
    for (const auto& point : x) corner = corner.cwiseMin(point).eval();
    return corner;
}

Vec<3> TriSurface::high() const {
    Vec<3> corner = x.front();
    for (const auto& point : x) corner = corner.cwiseMax(point).eval();
    return corner;
}

int TriSurface::regionNamed(const std::string& name) const {
    const auto found = std::find(regions.begin(), regions.end(), name);
    return found == regions.end() ? -1 : static_cast<int>(found - regions.begin());
}

void TriSurface::addRegion(const std::string& name, const std::vector<Face<3>>& faces) {
    int index = regionNamed(name);
    if (index < 0) {
        index = static_cast<int>(regions.size());
        regions.push_back(name);
    }
    triangles.insert(triangles.end(), faces.begin(), faces.end());
    region.resize(triangles.size(), index);
}

double volumeInside(const TriSurface& surface) {
    double volume = 0;
    const Vec<3> o = surface.x.front();
    for (const auto& t : surface.triangles) volume += (surface.x[t[0]] - o).dot(faceArea<3>(surface.x, t)) / 3;
    return volume;
}

double areaOf(const TriSurface& surface, int region) {
    double area = 0;
    for (int k = 0; k < surface.size(); ++k)
        if (region < 0 || surface.region[k] == region) area += faceArea<3>(surface.x, surface.triangles[k]).norm();
    return area;
}

}  // namespace pfem
