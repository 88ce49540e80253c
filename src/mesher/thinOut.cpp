#include "mesher/thinOut.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/segmentDistance.hpp"

namespace pfem {

namespace {

/// Keep, between the points `from` and `to`, the farthest one from the straight line, and so on with both halves,
/// until all are within their tolerance.
void keepFarthest(const Points<2>& x, const std::vector<double>& tolerance, std::size_t from, std::size_t to,
                  std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> parts = {{from, to}};
    while (!parts.empty()) {
        const auto [a, b] = parts.back();
        parts.pop_back();
        const bool closed = x[a] == x[b];
        double worst = closed ? 0 : 1;
        std::size_t at = 0;
        for (std::size_t k = a + 1; k < b; ++k) {
            const double away = (closed ? (x[k] - x[a]).norm() : segmentDistance(x[k], x[a], x[b])) / tolerance[k];
            if (away > worst) worst = away, at = k;
        }
        if (at == 0) continue;
        kept[at] = true;
        parts.emplace_back(a, at);
        parts.emplace_back(at, b);
    }
}

/// Between two kept points of a curve keep others, one per mesh size.
void keepEvenly(const Points<2>& x, const std::vector<double>& h, std::size_t from, std::size_t to,
                std::vector<bool>& kept) {
    std::vector<double> s = {0};  // edges of the mesh from the first point on
    for (std::size_t k = from; k < to; ++k) s.push_back(s.back() + (x[k + 1] - x[k]).norm() / std::min(h[k], h[k + 1]));
    const double n = std::round(s.back());
    for (double i = 1; i < n; ++i) {
        const double wanted = s.back() * i / n;
        const auto after = std::lower_bound(s.begin(), s.end(), wanted);
        const auto nearest = wanted - *(after - 1) < *after - wanted ? after - 1 : after;
        if (std::abs(*nearest - wanted) < 0.25) kept[from + static_cast<std::size_t>(nearest - s.begin())] = true;
    }
}

}  // namespace

std::vector<bool> denseEdges(const Points<2>& x, const std::vector<double>& h) {
    const std::size_t n = x.size() - 1;
    const bool closed = x.front() == x.back();
    std::vector<bool> dense(n, false);
    for (std::size_t k = 0; k < n; ++k) {
        if ((x[k + 1] - x[k]).norm() >= 0.5 * std::min(h[k], h[k + 1])) continue;
        dense[k] = true;
        if (k > 0 || closed) dense[(k + n - 1) % n] = true;
        if (k + 1 < n || closed) dense[(k + 1) % n] = true;
    }
    return dense;
}

std::vector<bool> thinOut(const Points<2>& x, const std::vector<double>& h) {
    const std::vector<bool> dense = denseEdges(x, h);
    std::vector<bool> kept(x.size(), true);
    std::vector<double> tolerance;
    for (const double size : h) tolerance.push_back(thinOutTolerance * size);
    for (std::size_t from = 0; from < dense.size();) {
        std::size_t to = from;
        while (to < dense.size() && dense[to]) kept[++to] = false;
        kept[to] = true;
        if (to > from) keepFarthest(x, tolerance, from, to, kept);
        from = std::max(to, from + 1);
    }
    const auto forEachGap = [&](const auto& f) {
        const std::vector<bool> ends = kept;  // NOLINT(performance-unnecessary-copy-initialization): f changes `kept`
        for (std::size_t from = 0, to = 1; to < x.size(); ++to) {
            if (!ends[to]) continue;
            if (to > from + 1) f(from, to);
            from = to;
        }
    };
    forEachGap([&](std::size_t from, std::size_t to) { keepEvenly(x, h, from, to, kept); });
    forEachGap([&](std::size_t from, std::size_t to) { keepFarthest(x, tolerance, from, to, kept); });
    if (x.front() == x.back() && std::count(kept.begin(), kept.end(), true) < 4) kept.assign(x.size(), true);
    return kept;
}

double lengthWithin(const Points<2>& x, double tolerance) {
    if (x.size() < 2) return 0;
    std::vector<bool> kept(x.size(), false);
    kept.front() = kept.back() = true;
    keepFarthest(x, std::vector<double>(x.size(), tolerance), 0, x.size() - 1, kept);
    double sum = 0;
    Vec<2> last = x.front();
    for (std::size_t k = 1; k < x.size(); ++k)
        if (kept[k]) sum += (x[k] - last).norm(), last = x[k];
    return sum;
}

}  // namespace pfem
