#include "mesher/sizeField.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/counts.hpp"
#include "state/placeSizes.hpp"

namespace pfem {

SizeField::SizeField(const MeshDescription& mesh, const Arrangement& arrangement) : refinements_(mesh.refinements) {
    for (const auto& body : mesh.bodies) bodySize_.push_back(bodySize(mesh, body));
    const double fallback = mesh.meshSize > 0   ? mesh.meshSize
                            : bodySize_.empty() ? 0
                                                : *std::min_element(bodySize_.begin(), bodySize_.end());
    for (const auto& piece : arrangement.pieces) {
        double h = std::numeric_limits<double>::max();
        for (const auto& use : piece.uses) {
            const bool wall = use.outline >= arrangement.nBodies;
            const double own = wall ? mesh.walls[use.outline - arrangement.nBodies].meshSize : bodySize_[use.outline];
            if (own > 0) h = std::min(h, own);
        }
        if (h == std::numeric_limits<double>::max()) h = fallback;
        if (piece.fixed) h = piece.curve.length();
        pieceSize_.push_back(h);
    }
    if (pieceSize_.empty()) return;
    const double largest = std::max(*std::max_element(pieceSize_.begin(), pieceSize_.end()),
                                    *std::max_element(bodySize_.begin(), bodySize_.end()));
    for (std::size_t i = 0; i < pieceSize_.size(); ++i) {
        const double h = pieceSize_[i];
        if (h >= largest * (1 - 1e-9)) continue;
        const Curve& curve = arrangement.pieces[i].curve;
        const int n = std::max(1, countAbove(curve.length() / h));
        for (int k = 0; k <= n; ++k) sources_.push_back({curve.point(double(k) / n), h});
    }
    std::stable_sort(sources_.begin(), sources_.end(), [](const Source& a, const Source& b) { return a.h < b.h; });
}

double SizeField::at(const Vec<2>& x, double cap) const {
    double h = cap;
    for (const auto& source : sources_) {
        if (source.h >= h) break;
        const double reach = (h - source.h) / sizeGrowth;
        const double squared = (x - source.x).squaredNorm();
        if (squared < reach * reach) h = source.h + sizeGrowth * std::sqrt(squared);
    }
    for (const auto& refinement : refinements_)
        if (refinement.meshSize < h) h = std::min(h, refinement.meshSize + sizeGrowth * refinement.away(x));
    return h;
}

double SizeField::smallest() const {
    double h = *std::min_element(pieceSize_.begin(), pieceSize_.end());
    for (const auto& refinement : refinements_) h = std::min(h, refinement.meshSize);
    return h;
}

bool SizeField::graded(double cap) const {
    const bool finer = std::any_of(refinements_.begin(), refinements_.end(),
                                   [&](const Refinement& refinement) { return refinement.meshSize < 0.95 * cap; });
    return finer || (!sources_.empty() && sources_.front().h < 0.95 * cap);
}

namespace {

/// Parameters of the nodes inside the curve: equal parts of the integral of ds / h.
std::vector<double> divide(const Curve& curve, double h, const SizeField& size) {
    std::vector<double> inner;
    const double length = curve.length();
    if (!size.graded(h)) {
        const int n = nearestCount(length / h);
        for (int k = 1; k < n; ++k) inner.push_back(double(k) / n);
        return inner;
    }
    const int m = std::max(8, countAbove(8 * length / size.smallest()));
    std::vector<double> sum(m + 1, 0.0);  // number of edges up to k / m
    for (int k = 0; k < m; ++k) sum[k + 1] = sum[k] + length / m / size.at(curve.point((k + 0.5) / m), h);
    const int n = nearestCount(sum[m]);
    for (int i = 1, k = 0; i < n; ++i) {
        const double wanted = sum[m] * i / n;
        while (sum[k + 1] < wanted) ++k;
        inner.push_back((k + (wanted - sum[k]) / (sum[k + 1] - sum[k])) / m);
    }
    return inner;
}

}  // namespace

BoundaryNodes divideBoundary(const Arrangement& arrangement, const SizeField& size) {
    BoundaryNodes nodes;
    nodes.x = arrangement.vertices;
    nodes.h.assign(nodes.x.size(), std::numeric_limits<double>::max());
    for (std::size_t i = 0; i < arrangement.pieces.size(); ++i) {
        const Piece& piece = arrangement.pieces[i];
        const double h = size.ofPiece(static_cast<int>(i));
        std::vector<int> chain = {piece.a};
        if (!piece.fixed) {
            for (const double s : divide(piece.curve, h, size)) {
                chain.push_back(static_cast<int>(nodes.x.size()));
                nodes.x.push_back(piece.curve.point(s));
                nodes.h.push_back(size.at(nodes.x.back(), h));
            }
        }
        chain.push_back(piece.b);
        for (const int end : {piece.a, piece.b}) nodes.h[end] = std::min(nodes.h[end], size.at(nodes.x[end], h));
        nodes.ofPiece.push_back(std::move(chain));
    }
    return nodes;
}

std::vector<int> BoundaryNodes::chain(const Arrangement& arrangement, int outline, bool closed) const {
    std::vector<int> nodes;
    for (const auto& ref : arrangement.chains[outline]) {
        std::vector<int> piece = ofPiece[ref.piece];
        if (!ref.forward) std::reverse(piece.begin(), piece.end());
        nodes.insert(nodes.end(), piece.begin(), piece.end() - 1);
        if (!closed && &ref == &arrangement.chains[outline].back()) nodes.push_back(piece.back());
    }
    return nodes;
}

}  // namespace pfem
