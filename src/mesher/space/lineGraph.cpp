#include "mesher/space/lineGraph.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "mesh/bins.hpp"
#include "mesh/distance.hpp"

namespace pfem {

namespace {

/// Parameters of the nearest points of two lines that are not parallel.
std::optional<std::array<double, 2>> nearestParameters(const std::array<Vec<3>, 2>& p, const std::array<Vec<3>, 2>& q) {
    const Vec<3> u = p[1] - p[0], w = q[1] - q[0], r = p[0] - q[0];
    const double a = u.squaredNorm(), b = u.dot(w), c = w.squaredNorm(), det = a * c - b * b;
    if (!(det > 1e-12 * a * c)) return {};
    return std::array<double, 2>{(b * w.dot(r) - c * u.dot(r)) / det, (a * w.dot(r) - b * u.dot(r)) / det};
}

}  // namespace

int LineGraph::point(const Vec<3>& x) {
    x_.push_back(x);
    return static_cast<int>(x_.size()) - 1;
}

void LineGraph::add(const Vec<3>& a, const Vec<3>& b) {
    const int i = point(a), j = point(b);
    pieces_.push_back({i, j});
}

/// Points at one place are one; pieces without length and doubled ones go.
void LineGraph::sortPieces() {
    std::vector<int> order(x_.size()), first(x_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = first[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return x_[i][0] < x_[j][0]; });
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size() && x_[order[j]][0] - x_[order[i]][0] <= tolerance_; ++j)
            if ((x_[order[i]] - x_[order[j]]).norm() <= tolerance_) {
                const int a = first[order[i]], b = first[order[j]];
                first[order[i]] = first[order[j]] = std::min(a, b);
            }
    for (auto& piece : pieces_) {
        for (int& i : piece)
            while (first[i] != i) i = first[i];
        if (piece[0] > piece[1]) std::swap(piece[0], piece[1]);
    }
    std::erase_if(pieces_, [](const Piece& p) { return p[0] == p[1]; });
    std::sort(pieces_.begin(), pieces_.end());
    pieces_.erase(std::unique(pieces_.begin(), pieces_.end()), pieces_.end());
}

void LineGraph::cut() {
    sortPieces();
    if (pieces_.empty()) return;
    double mean = 0;
    for (const auto& [a, b] : pieces_) mean += (x_[a] - x_[b]).norm() / static_cast<double>(pieces_.size());
    Vec<3> low = x_.front(), high = low;
    for (const auto& x : x_) low = low.cwiseMin(x).eval(), high = high.cwiseMax(x).eval();
    Bins<3> bins(low, high, std::max(mean, 0.02 * (high - low).maxCoeff()));
    const Vec<3> slack = Vec<3>::Constant(tolerance_);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        const auto &a = x_[pieces_[k][0]], &b = x_[pieces_[k][1]];
        bins.add(static_cast<int>(k), a.cwiseMin(b) - slack, a.cwiseMax(b) + slack);
    }
    std::vector<Piece> all;
    const std::size_t n = pieces_.size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::array<Vec<3>, 2> p{x_[pieces_[k][0]], x_[pieces_[k][1]]};
        const double length = (p[1] - p[0]).norm();
        std::vector<std::pair<double, int>> cuts{{0.0, pieces_[k][0]}, {1.0, pieces_[k][1]}};
        const auto cutAt = [&](double s, int at) {
            if (s * length > tolerance_ && (1 - s) * length > tolerance_) cuts.emplace_back(s, at);
        };
        bins.parallelFor(p[0].cwiseMin(p[1]) - slack, p[0].cwiseMax(p[1]) + slack, [&](int other) {
            if (other == static_cast<int>(k)) return;
            const std::array<Vec<3>, 2> q{x_[pieces_[other][0]], x_[pieces_[other][1]]};
            for (int e = 0; e < 2; ++e)  // ends of the other one on this one
                if (distanceToSegment<3>(p[0], p[1], q[e]) <= tolerance_)
                    cutAt(nearestWeight<3>(p[0], p[1], q[e]), pieces_[other][e]);
            const auto s = nearestParameters(p, q);
            if (!s || (*s)[0] < 0 || (*s)[0] > 1 || (*s)[1] < 0 || (*s)[1] > 1) return;
            const Vec<3> x = p[0] + (*s)[0] * (p[1] - p[0]), y = q[0] + (*s)[1] * (q[1] - q[0]);
            const double beyond = std::min((*s)[1], 1 - (*s)[1]) * (q[1] - q[0]).norm();
            if ((x - y).norm() <= tolerance_ && beyond > tolerance_) cutAt((*s)[0], point(x));
        });
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t c = 0; c + 1 < cuts.size(); ++c) all.push_back({cuts[c].second, cuts[c + 1].second});
    }
    pieces_ = std::move(all);
    sortPieces();
}

std::vector<Points<3>> LineGraph::lines(double sharpCosine) const {
    std::map<int, std::vector<int>> around;  // pieces of a point
    for (std::size_t k = 0; k < pieces_.size(); ++k)
        for (const int i : pieces_[k]) around[i].push_back(static_cast<int>(k));
    const auto other = [&](int piece, int i) { return pieces_[piece][0] == i ? pieces_[piece][1] : pieces_[piece][0]; };
    const auto isCorner = [&](int i) {
        const auto& mine = around.at(i);
        if (mine.size() != 2) return true;
        const Vec<3> u = x_[i] - x_[other(mine[0], i)], w = x_[other(mine[1], i)] - x_[i];
        return u.normalized().dot(w.normalized()) < sharpCosine;
    };
    std::vector<bool> taken(pieces_.size(), false);
    std::vector<Points<3>> result;
    const auto follow = [&](int start, int piece) {
        Points<3> line{x_[start]};
        int at = start;
        for (;;) {
            taken[piece] = true;
            at = other(piece, at);
            line.push_back(x_[at]);
            if (at == start || isCorner(at)) break;
            const auto& mine = around.at(at);
            piece = mine[0] == piece ? mine[1] : mine[0];
        }
        result.push_back(line);
    };
    for (const auto& [i, mine] : around)
        if (isCorner(i))
            for (const int piece : mine)
                if (!taken[piece]) follow(i, piece);
    for (std::size_t k = 0; k < pieces_.size(); ++k)  // closed ones without a corner
        if (!taken[k]) follow(pieces_[k][0], static_cast<int>(k));
    return result;
}

}  // namespace pfem
