#include "mesher/space/shapes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

namespace pfem {

namespace {

/// Points of a circle, turning round `axis` (a unit vector).
Points<3> circle(const Vec<3>& centre, const Vec<3>& axis, double radius, int n) {
    // the same directions for both senses of the axis, so that circles of touching shapes coincide
    const Vec<3> u = std::abs(axis[0]) < 0.9 ? Vec<3>((Vec<3>::UnitX() - axis[0] * axis).normalized())
                                             : Vec<3>((Vec<3>::UnitY() - axis[1] * axis).normalized());
    const Vec<3> w = axis.cross(u);
    Points<3> points;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        points.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * w));
    }
    return points;
}

int addPoints(TriSurface& surface, const Points<3>& points) {
    const int first = static_cast<int>(surface.x.size());
    surface.x.insert(surface.x.end(), points.begin(), points.end());
    return first;
}

/// A fan round the point `hub` over a ring of n points from `first` on.
std::vector<Face<3>> fan(int hub, int first, int n, bool turned) {
    std::vector<Face<3>> faces;
    for (int k = 0; k < n; ++k) {
        const int a = first + k, b = first + (k + 1) % n;
        faces.push_back(turned ? Face<3>{hub, b, a} : Face<3>{hub, a, b});
    }
    return faces;
}

}  // namespace

TriSurface boxSurface(const Vec<3>& low, const Vec<3>& high) {
    TriSurface s;
    for (int k = 0; k < 8; ++k)
        s.x.push_back({k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
    const auto side = [&](const char* name, int i, int j, int k, int l) { s.addRegion(name, {{i, j, k}, {i, k, l}}); };
    side("xMin", 0, 4, 6, 2);
    side("xMax", 1, 3, 7, 5);
    side("yMin", 0, 1, 5, 4);
    side("yMax", 2, 6, 7, 3);
    side("zMin", 0, 2, 3, 1);
    side("zMax", 4, 5, 7, 6);
    return s;
}

TriSurface coneSurface(const Vec<3>& p1, double r1, const Vec<3>& p2, double r2, int segments) {
    const Vec<3> axis = (p2 - p1).normalized();
    TriSurface s;
    const int n = segments, hub1 = addPoints(s, {p1}), hub2 = addPoints(s, {p2});
    const int ring1 = r1 > 0 ? addPoints(s, circle(p1, axis, r1, n)) : -1,
              ring2 = r2 > 0 ? addPoints(s, circle(p2, axis, r2, n)) : -1;
    std::vector<Face<3>> side;
    for (int k = 0; k < n; ++k) {
        const int l = (k + 1) % n;
        if (r1 > 0) side.push_back({ring1 + k, ring1 + l, r2 > 0 ? ring2 + l : hub2});
        if (r2 > 0) side.push_back({r1 > 0 ? ring1 + k : hub1, ring2 + l, ring2 + k});
    }
    s.addRegion("side", side);
    if (r1 > 0) s.addRegion("end1", fan(hub1, ring1, n, true));
    if (r2 > 0) s.addRegion("end2", fan(hub2, ring2, n, false));
    return s;
}

TriSurface sphereSurface(const Vec<3>& centre, double radius, int segments) {
    const int n = std::max(1, segments / 4);  // parts of the edges of an octahedron
    TriSurface s;
    std::map<std::array<int, 3>, int> number;
    const auto point = [&](const std::array<int, 3>& at) {
        const auto [found, isNew] = number.emplace(at, static_cast<int>(s.x.size()));
        if (isNew) {
            // equal angles along the edges: sin of parts of the quarter
            Vec<3> d;
            for (int k = 0; k < 3; ++k) d[k] = std::sin(0.5 * std::numbers::pi * at[k] / n);
            s.x.push_back(centre + radius * d.normalized());
        }
        return found->second;
    };
    std::vector<Face<3>> faces;
    for (int octant = 0; octant < 8; ++octant) {
        const std::array<int, 3> sign{octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
        const bool turned = sign[0] * sign[1] * sign[2] < 0;
        const auto at = [&](int i, int j) { return point({sign[0] * i, sign[1] * j, sign[2] * (n - i - j)}); };
        const auto add = [&](int a, int b, int c) { faces.push_back(turned ? Face<3>{a, c, b} : Face<3>{a, b, c}); };
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                add(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
    }
    s.addRegion("surface", faces);
    return s;
}

TriSurface planeSurface(const Vec<3>& centre, const Vec<3>& normal, double side) {
    const Vec<3> n = normal.normalized();
    int axis = 0;
    n.cwiseAbs().minCoeff(&axis);
    const Vec<3> e = Vec<3>::Unit(axis), u = 0.5 * side * (e - e.dot(n) * n).normalized(), w = n.cross(u);
    TriSurface s;
    s.x = {centre - u - w, centre + u - w, centre + u + w, centre - u + w};
    s.addRegion("plane", {{0, 1, 2}, {0, 2, 3}});
    return s;
}

TriSurface diskSurface(const Vec<3>& centre, const Vec<3>& normal, double radius, int segments) {
    TriSurface s;
    const int hub = addPoints(s, {centre}), ring = addPoints(s, circle(centre, normal.normalized(), radius, segments));
    s.addRegion("disk", fan(hub, ring, segments, false));
    return s;
}

TriSurface extrudedSurface(const Polygon& outline, const Vec<3>& from, const Vec<3>& by) {
    const Points<2>& polygon = outline.points;
    const int n = static_cast<int>(polygon.size());
    TriSurface s;
    for (const Vec<3>& shift : {from, Vec<3>(from + by)})
        for (const auto& p : polygon) s.x.push_back(Vec<3>(p[0], p[1], 0) + shift);
    const auto caps = polygonTriangles(polygon);
    std::vector<Face<3>> start, end;
    for (const auto& [a, b, c] : caps) {
        start.push_back({a, c, b});
        end.push_back({n + a, n + b, n + c});
    }
    for (int k = 0; k < n; ++k) {
        const int l = (k + 1) % n;
        s.addRegion("edge" + std::to_string(outline.edge[k]), {{k, l, n + l}, {k, n + l, n + k}});
    }
    s.addRegion("start", start);
    s.addRegion("end", end);
    if (by[2] < 0)
        for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
}

TriSurface turnedSurface(const Polygon& outline, int axis, double angle, int segments) {
    const Points<2>& polygon = outline.points;
    const int n = static_cast<int>(polygon.size()), along = axis == 0 ? 0 : 1, out = 1 - along;
    const bool whole = angle > 2 * std::numbers::pi - 1e-9;
    const int rings = whole ? segments : segments + 1;
    TriSurface s;
    std::vector<std::vector<int>> at(rings, std::vector<int>(n));
    for (int r = 0; r < rings; ++r)
        for (int k = 0; k < n; ++k) {
            const double a = angle * r / segments, radius = polygon[k][out];
            if (radius == 0 && r > 0) {
                at[r][k] = at[0][k];
                continue;
            }
            at[r][k] = static_cast<int>(s.x.size());
            Vec<3> x;
            x[axis] = polygon[k][along];
            x[(axis + 1) % 3] = radius * std::cos(a);
            x[(axis + 2) % 3] = radius * std::sin(a);
            s.x.push_back(x);
        }
    for (int k = 0; k < n; ++k) {
        const int l = (k + 1) % n;
        std::vector<Face<3>> faces;
        const auto add = [&](int a, int b, int c) {
            if (a != b && b != c && c != a) faces.push_back({a, b, c});
        };
        for (int r = 0; r < segments; ++r) {
            const int next = (r + 1) % rings;
            add(at[r][k], at[r][l], at[next][l]);
            add(at[r][k], at[next][l], at[next][k]);
        }
        if (!faces.empty()) s.addRegion("edge" + std::to_string(outline.edge[k]), faces);
    }
    if (!whole) {
        std::vector<Face<3>> start, end;
        for (const auto& [a, b, c] : polygonTriangles(polygon)) {
            start.push_back({at[0][a], at[0][c], at[0][b]});
            end.push_back({at[segments][a], at[segments][b], at[segments][c]});
        }
        s.addRegion("start", start);
        s.addRegion("end", end);
    }
    if (volumeInside(s) < 0)
        for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
}

}  // namespace pfem
