#include "mesher/simplify.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "mesher/thinOut.hpp"

namespace pfem {

namespace {

/// Pieces of the same outlines, one behind the other: vertex k to k+1 is piece k.
struct Line {
    std::vector<int> vertices, pieces;
};

/// What a piece is for each of its outlines, seen along a line: outline, rim of a hole, direction, names of patches.
using SideKinds = std::multiset<std::tuple<int, bool, bool, std::vector<std::string>>>;

class Simplifier {
public:
    Simplifier(const Arrangement& arrangement, const MeshDescription& mesh, const SizeField& size)
        : old_(arrangement), mesh_(mesh), size_(size), at_(old_.vertices.size()), replaced_(old_.pieces.size()) {
        for (std::size_t p = 0; p < old_.pieces.size(); ++p)
            for (const int v : {old_.pieces[p].a, old_.pieces[p].b}) at_[v].push_back(static_cast<int>(p));
        for (std::size_t w = 0; w < mesh.walls.size(); ++w) {
            const auto& chain = old_.chains[old_.nBodies + static_cast<int>(w)];
            if (mesh.walls[w].closed || chain.empty()) continue;
            at_[old_.startOf(chain.front())].push_back(-1);  // its ends stay
            at_[old_.endOf(chain.back())].push_back(-1);
        }
    }

    Simplified result() {
        Simplified result{old_, old_.spikes};
        result.arrangement.pieces.clear();
        std::vector<bool> seen(old_.pieces.size(), false);
        for (std::size_t p = 0; p < old_.pieces.size(); ++p) {
            if (seen[p]) continue;
            const Line line = lineOf(static_cast<int>(p));
            for (const int q : line.pieces) seen[q] = true;
            replace(line, result);
        }
        for (auto& chain : result.arrangement.chains) chain = renamed(chain);
        dropVertices(result.arrangement);
        return result;
    }

private:
    SideKinds sidesOf(int piece, bool along) const {
        SideKinds sides;
        for (const auto& use : old_.pieces[piece].uses) {
            const bool body = use.outline < old_.nBodies && use.edge >= 0;
            sides.emplace(use.outline, use.edge < 0, use.forward == along,
                          body ? patchesOf(mesh_.bodies[use.outline], use.edge) : std::vector<std::string>());
        }
        return sides;
    }

    /// The piece that goes on from `piece` at `vertex`; -1 where the line ends.
    int next(int piece, int vertex) const {
        const auto& both = at_[vertex];
        if (both.size() != 2 || both[0] == both[1]) return -1;
        const int other = both[0] == piece ? both[1] : both[0];
        if (other < 0) return -1;
        const Piece &p = old_.pieces[piece], &q = old_.pieces[other];
        if (p.fixed || q.fixed || p.curve.isArc() || q.curve.isArc()) return -1;
        return sidesOf(piece, p.b == vertex) == sidesOf(other, q.a == vertex) ? other : -1;
    }

    /// The whole line that `piece` is part of. A closed one begins where no vertex can be left out or, dense all
    /// around, at its lowest vertex on the left, whichever is written first.
    Line lineOf(int piece) const {
        Line line{{old_.pieces[piece].a, old_.pieces[piece].b}, {piece}};
        const auto extend = [&] {
            for (int p = next(line.pieces.back(), line.vertices.back()); p >= 0 && p != line.pieces.front();
                 p = next(p, line.vertices.back())) {
                const Piece& q = old_.pieces[p];
                line.pieces.push_back(p);
                line.vertices.push_back(q.a == line.vertices.back() ? q.b : q.a);
            }
        };
        extend();
        if (line.vertices.front() == line.vertices.back()) return turned(line);
        std::reverse(line.pieces.begin(), line.pieces.end());
        std::reverse(line.vertices.begin(), line.vertices.end());
        extend();
        return line;
    }

    Line turned(Line line) const {
        if (next(line.pieces.back(), line.vertices.back()) < 0) return line;  // other outlines touch it there
        const auto dense = denseEdges(points(line), sizes(line));
        auto start = static_cast<std::size_t>(std::find(dense.begin(), dense.end(), false) - dense.begin()) + 1;
        line.vertices.pop_back();
        if (start > dense.size()) {
            const auto before = [&](int v, int w) {
                const Vec<2>&x = old_.vertices[v], &y = old_.vertices[w];
                return std::make_pair(x.x(), x.y()) < std::make_pair(y.x(), y.y());
            };
            start = static_cast<std::size_t>(std::min_element(line.vertices.begin(), line.vertices.end(), before) -
                                             line.vertices.begin());
        }
        start %= line.vertices.size();
        std::rotate(line.vertices.begin(), line.vertices.begin() + static_cast<long>(start), line.vertices.end());
        std::rotate(line.pieces.begin(), line.pieces.begin() + static_cast<long>(start), line.pieces.end());
        line.vertices.push_back(line.vertices.front());
        return line;
    }

    Points<2> points(const Line& line) const {
        Points<2> x;
        for (const int v : line.vertices) x.push_back(old_.vertices[v]);
        return x;
    }
    std::vector<double> sizes(const Line& line) const {
        std::vector<double> h;
        for (const int v : line.vertices) h.push_back(size_.at(old_.vertices[v], size_.ofPiece(line.pieces.front())));
        return h;
    }

    /// Pieces between the kept vertices of the line.
    void replace(const Line& line, Simplified& result) {
        const auto kept = thinOut(points(line), sizes(line));
        for (std::size_t from = 0, to = 1; to < line.vertices.size(); ++to) {
            if (!kept[to]) continue;
            const int a = line.vertices[from], b = line.vertices[to];
            Piece piece = old_.pieces[line.pieces[from]];
            if (to > from + 1) {
                const bool along = piece.a == a;
                piece.a = a;
                piece.b = b;
                piece.curve = Curve::line(old_.vertices[a], old_.vertices[b]);
                for (auto& use : piece.uses) {
                    use.forward = use.forward == along;
                    if (use.edge >= 0) result.leftOut[use.outline] += static_cast<int>(to - from) - 1;
                }
            }
            for (std::size_t k = from; k < to; ++k)  // the line goes from the new piece's a to its b, or against it
                replaced_[line.pieces[k]] = {static_cast<int>(result.arrangement.pieces.size()),
                                             (old_.pieces[line.pieces[k]].a == line.vertices[k]) == (piece.a == a)};
            result.arrangement.pieces.push_back(piece);
            from = to;
        }
    }

    std::vector<PieceRef> renamed(const std::vector<PieceRef>& chain) const {
        std::vector<PieceRef> refs;
        for (const auto& ref : chain) {
            const PieceRef now{replaced_[ref.piece].piece, ref.forward == replaced_[ref.piece].forward};
            if (refs.empty() || refs.back().piece != now.piece || refs.back().forward != now.forward)
                refs.push_back(now);
        }
        if (refs.size() > 1 && refs.back().piece == refs.front().piece && refs.back().forward == refs.front().forward)
            refs.pop_back();
        return refs;
    }

    const Arrangement& old_;
    const MeshDescription& mesh_;
    const SizeField& size_;
    std::vector<std::vector<int>> at_;  // pieces at each vertex
    std::vector<PieceRef> replaced_;    // per old piece: the new one, and whether it has the same direction
};

}  // namespace

bool Simplified::changed() const {
    return std::any_of(leftOut.begin(), leftOut.end(), [](int n) { return n > 0; });
}

Simplified simplify(const Arrangement& arrangement, const MeshDescription& mesh, const SizeField& size) {
    return Simplifier(arrangement, mesh, size).result();
}

}  // namespace pfem
