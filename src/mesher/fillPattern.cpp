#include "mesher/region.hpp"

namespace pfem {

// Node (i, j), i = 0 .. nx along edge 0-1, j = 0 .. ny along edge 1-2. The boundary loop runs along the
// bottom, up the right side, back along the top and down the left side. Inner nodes by transfinite
// interpolation: exact cells for a rectangle, and it follows curved sides.
std::vector<Simplex<2>> fillPattern(Region& region, Pattern pattern, std::array<int, 2> cells) {
    const auto [nx, ny] = cells;
    const auto bottom = [](int i) { return i; };
    const auto right = [nx = nx](int j) { return nx + j; };
    const auto top = [nx = nx, ny = ny](int i) { return nx + ny + (nx - i); };
    const auto left = [nx = nx, ny = ny](int j) { return j == 0 ? 0 : 2 * nx + ny + (ny - j); };

    std::vector<int> node((nx + 1) * (ny + 1));
    const auto at = [&, nx = nx](int i, int j) -> int& { return node[j * (nx + 1) + i]; };
    for (int i = 0; i <= nx; ++i) at(i, 0) = bottom(i), at(i, ny) = top(i);
    for (int j = 0; j <= ny; ++j) at(0, j) = left(j), at(nx, j) = right(j);
    for (int j = 1; j < ny; ++j) {
        for (int i = 1; i < nx; ++i) {
            const double u = double(i) / nx, v = double(j) / ny;
            const auto& x = region.x;
            const Vec<2> corners = (1 - u) * (1 - v) * x[bottom(0)] + u * (1 - v) * x[bottom(nx)] + u * v * x[top(nx)] +
                                   (1 - u) * v * x[top(0)];
            const Vec<2> inner =
                (1 - v) * x[bottom(i)] + v * x[top(i)] + (1 - u) * x[left(j)] + u * x[right(j)] - corners;
            at(i, j) = static_cast<int>(x.size());
            region.x.push_back(inner);
        }
    }
    std::vector<Simplex<2>> triangles;
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if (pattern == Pattern::crossed) {
                const int m = static_cast<int>(region.x.size());
                const Vec<2> centre = 0.25 * (region.x[a] + region.x[b] + region.x[c] + region.x[d]);
                region.x.push_back(centre);
                triangles.insert(triangles.end(), {{a, b, m}, {b, c, m}, {c, d, m}, {d, a, m}});
            } else if (pattern == Pattern::oneWay || (i + j) % 2 == 0) {
                triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
            } else {
                triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
            }
        }
    }
    return triangles;
}

}  // namespace pfem
