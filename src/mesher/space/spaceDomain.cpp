#include "mesher/space/spaceDomain.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace pfem {

namespace {

BoxTree treeOf(const std::vector<TriSurface>& surfaces, std::vector<int>& owner) {
    std::vector<BoxTree::Triangle> triangles;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (const auto& [a, b, c] : surfaces[s].triangles) {
            triangles.push_back({surfaces[s].x[a], surfaces[s].x[b], surfaces[s].x[c]});
            owner.push_back(static_cast<int>(s));
        }
    return BoxTree(std::move(triangles));
}

/// The part of a segment in a box, nothing outside of it. Segments of Voronoi cells may be 1e15 long: places on them
/// are found with the numbers that are left.
bool clip(const Vec<3>& low, const Vec<3>& high, Vec<3>& a, Vec<3>& b) {
    for (int turn = 0; turn < 2; ++turn) {
        for (int d = 0; d < 3; ++d)
            for (const double bound : {low[d], high[d]}) {
                const bool below = bound == low[d];
                if (below ? a[d] >= bound : a[d] <= bound) continue;
                if (below ? b[d] < bound : b[d] > bound) return false;
                a += (bound - a[d]) / (b[d] - a[d]) * (b - a);
                a[d] = bound;
            }
        std::swap(a, b);
    }
    return true;
}

/// Onto the plane of a triangle; on a plane of the axes to the last bit.
void setOnPlane(const BoxTree::Triangle& t, Vec<3>& x) {
    const Vec<3> n = (t[1] - t[0]).cross(t[2] - t[0]);
    x -= n.dot(x - t[0]) / n.squaredNorm() * n;
    for (int d = 0; d < 3; ++d)
        if (t[0][d] == t[1][d] && t[0][d] == t[2][d]) x[d] = t[0][d];
}

}  // namespace

SpaceDomain::SpaceDomain(std::vector<TriSurface> surfaces, std::vector<BodySpace> bodies)
    : surfaces_(std::move(surfaces)), bodies_(std::move(bodies)), tree_(treeOf(surfaces_, owner_)) {
    low_ = surfaces_.front().low();
    high_ = surfaces_.front().high();
    for (const auto& surface : surfaces_) {
        inside_.push_back(std::make_unique<InsideTest>(surface));
        low_ = low_.cwiseMin(surface.low()).eval();
        high_ = high_.cwiseMax(surface.high()).eval();
    }
}

bool SpaceDomain::isIn(int body, const Vec<3>& x) const {
    const auto in = [&](int surface) { return (*inside_[surface])(x); };
    const auto& b = bodies_[body];
    return std::any_of(b.all.begin(), b.all.end(), in) && std::all_of(b.within.begin(), b.within.end(), in) &&
           std::none_of(b.without.begin(), b.without.end(), in);
}

int SpaceDomain::label(const Vec<3>& x) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (isIn(static_cast<int>(b), x)) return static_cast<int>(b) + 1;
    return 0;
}

std::optional<SpaceDomain::Crossing> SpaceDomain::crossing(const Vec<3>& from, const Vec<3>& to) const {
    const Vec<3> rim = 0.01 * (high_ - low_);
    Vec<3> a = from, b = to;
    if (!clip(low_ - rim, high_ + rim, a, b)) return {};
    std::vector<std::pair<double, int>> met;
    tree_.forEachMet(a, b, [&](int triangle, double t) { met.emplace_back(t, triangle); });
    if (met.empty()) return {};
    std::sort(met.begin(), met.end());
    int before = label(a);
    for (std::size_t k = 0; k < met.size(); ++k) {
        const double t = met[k].first;
        if (k + 1 < met.size() && met[k + 1].first - t < 1e-12) continue;  // two triangles at one place
        const double next = k + 1 < met.size() ? 0.5 * (t + met[k + 1].first) : 1;
        const int after = label(a + next * (b - a));
        if (after == before) continue;
        Vec<3> x = a + t * (b - a);
        for (std::size_t j = 0; j <= k; ++j)
            if (t - met[j].first < 1e-12) setOnPlane(tree_.triangle(met[j].second), x);
        return Crossing{x, std::minmax(before, after)};
    }
    return {};
}

}  // namespace pfem
