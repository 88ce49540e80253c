#include "linear/fronts.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace pfem {

Fronts makeFronts(const LowerColumns& A, const std::vector<Piece>& pieces) {
    Fronts result;
    result.front.reserve(pieces.size());
    std::vector<int> mark(A.n, -1), stack;
    for (const Piece& piece : pieces) {
        const int f = static_cast<int>(result.front.size());
        Front front{piece.first, piece.width, static_cast<int>(result.row.size()), 0, 0};
        const int end = front.first + front.width;
        const auto take = [&](int r) {
            if (r < end || mark[r] == f) return;
            mark[r] = f;
            result.row.push_back(r);
        };
        for (int s = A.start[front.first]; s < A.start[end]; ++s) take(A.row[s]);
        for (int c = 0; c < piece.nChildren; ++c, stack.pop_back()) {
            const Front& child = result.front[stack.back()];
            if (child.nRows > 0 && result.row[child.rows] < front.first)
                throw InternalError("a piece of the pressure matrix meets one that does not part it");
            for (int k = 0; k < child.nRows; ++k) take(result.row[child.rows + k]);
            if (child.nRows > 0 && result.row[child.rows] < A.nColumns()) ++front.nChildren;
        }
        front.nRows = static_cast<int>(result.row.size()) - front.rows;
        std::sort(result.row.begin() + front.rows, result.row.end());
        result.front.push_back(front);
        stack.push_back(f);
    }
    return result;
}

}  // namespace pfem
