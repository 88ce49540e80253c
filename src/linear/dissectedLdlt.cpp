#include "linear/dissectedLdlt.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "linear/denseFront.hpp"
#include "linear/nestedDissection.hpp"

namespace pfem {

namespace {

/// Which interior unknowns of a part meet. `place` per unknown: its index in the part, negative for others.
MatrixGraph interiorGraph(const SymmetricMatrix& A, const std::vector<int>& interior, const std::vector<int>& place) {
    const int n = static_cast<int>(interior.size());
    const auto forPairs = [&](const auto& visit) {
        for (int f = 0; f < n; ++f)
            for (int s = A.start[interior[f]] + 1; s < A.start[interior[f] + 1]; ++s)
                if (place[A.row[s]] >= 0) visit(f, place[A.row[s]]);
    };
    MatrixGraph graph;
    graph.start.assign(n + 1, 0);
    forPairs([&](int a, int b) {
        ++graph.start[a + 1];
        ++graph.start[b + 1];
    });
    for (int f = 0; f < n; ++f) graph.start[f + 1] += graph.start[f];
    graph.neighbour.resize(graph.start[n]);
    std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
    forPairs([&](int a, int b) {
        graph.neighbour[next[a]++] = b;
        graph.neighbour[next[b]++] = a;
    });
    return graph;
}

/// [A_ff A_fl; A_lf 0] of one part by columns; appends to `shared` the places it meets. `place` per unknown:
/// its index in the part, or -2 - its place among the shared ones, or -1 for those of other parts.
LowerColumns partColumns(const SymmetricMatrix& A, const std::vector<int>& interior, const std::vector<int>& place,
                         const std::vector<int>& sharedUnknown, std::vector<int>& shared) {
    const int n = static_cast<int>(interior.size());
    std::vector<int> last(sharedUnknown.size(), -1);
    const auto lastIndex = [&](int k) {
        if (last[k] < 0) {
            last[k] = n + static_cast<int>(shared.size());
            shared.push_back(k);
        }
        return last[k];
    };
    const auto forEntries = [&](const auto& visit) {  // visit(row, column, value)
        for (int f = 0; f < n; ++f)
            for (int s = A.start[interior[f]]; s < A.start[interior[f] + 1]; ++s) {
                const int at = place[A.row[s]];
                if (at >= 0)
                    visit(std::max(at, f), std::min(at, f), A.value[s]);
                else if (at <= -2)
                    visit(lastIndex(-2 - at), f, A.value[s]);
            }
        for (std::size_t k = 0; k < sharedUnknown.size(); ++k)
            for (int s = A.start[sharedUnknown[k]] + 1; s < A.start[sharedUnknown[k] + 1]; ++s)
                if (place[A.row[s]] >= 0) visit(lastIndex(static_cast<int>(k)), place[A.row[s]], A.value[s]);
    };
    LowerColumns M;
    M.start.assign(n + 1, 0);
    forEntries([&](int, int column, double) { ++M.start[column + 1]; });
    M.n = n + static_cast<int>(shared.size());
    for (int j = 0; j < n; ++j) M.start[j + 1] += M.start[j];
    M.row.resize(M.start[n]);
    M.value.resize(M.start[n]);
    std::vector<int> next(M.start.begin(), M.start.end() - 1);
    forEntries([&](int row, int column, double value) {
        M.row[next[column]] = row;
        M.value[next[column]++] = value;
    });
    return M;
}

/// `place` with the index of each interior unknown in its part.
std::vector<int> withInterior(std::vector<int> place, const std::vector<int>& interior) {
    for (std::size_t f = 0; f < interior.size(); ++f) place[interior[f]] = static_cast<int>(f);
    return place;
}

}  // namespace

template <int Dim, class Stored, class Real>
DissectedLdlt<Dim, Stored, Real>::DissectedLdlt(Places<Dim> where, std::vector<int> part, int nParts)
    : where_(std::move(where)), part_(std::move(part)), parts_(nParts) {}

template <int Dim, class Stored, class Real>
void DissectedLdlt<Dim, Stored, Real>::analyse(const SymmetricMatrix& A) {
    const int nParts = static_cast<int>(parts_.size());
    shared_.clear();
    for (Part& each : parts_) each = {};
    const auto isShared = nParts > 1 ? sharedUnknowns(A, part_) : std::vector<unsigned char>(A.n, 0);
    placeShared_.assign(A.n, -1);
    for (int i = 0; i < A.n; ++i) {
        if (isShared[i]) {
            placeShared_[i] = -2 - static_cast<int>(shared_.size());
            shared_.push_back(i);
        } else {
            parts_[nParts > 1 ? part_[i] : 0].interior.push_back(i);
        }
    }
    parallelTasks(nParts, [&](int p) {
        std::vector<int>& interior = parts_[p].interior;
        if (interior.empty()) return;
        Places<Dim> ofInterior;
        ofInterior.reserve(interior.size());
        for (int f : interior) ofInterior.push_back(where_[f]);
        auto [order, pieces] =
            nestedDissection<Dim>(interiorGraph(A, interior, withInterior(placeShared_, interior)), ofInterior);
        for (int& f : order) f = interior[f];
        interior = std::move(order);
        parts_[p].pieces = std::move(pieces);
    });
}

template <int Dim, class Stored, class Real>
void DissectedLdlt<Dim, Stored, Real>::factor(const SymmetricMatrix& A) {
    parallelTasks(static_cast<int>(parts_.size()), [&](int p) {
        Part& own = parts_[p];
        if (own.interior.empty()) return;
        own.shared.clear();
        const auto place = withInterior(placeShared_, own.interior);
        own.factor.factorize(partColumns(A, own.interior, place, shared_, own.shared), own.pieces);
    });
    if (!shared_.empty()) factorBetween(A);
}

/// What is left of the unknowns between the parts when the parts are eliminated.
template <int Dim, class Stored, class Real>
void DissectedLdlt<Dim, Stored, Real>::factorBetween(const SymmetricMatrix& A) {
    const int n = static_cast<int>(shared_.size());
    std::vector<int> place(A.n, -1);
    for (int k = 0; k < n; ++k) place[shared_[k]] = k;
    between_ = Eigen::MatrixXd::Zero(n, n);
    for (int k = 0; k < n; ++k)
        for (int s = A.start[shared_[k]]; s < A.start[shared_[k] + 1]; ++s) {
            const int other = place[A.row[s]];
            if (other >= 0) between_(std::max(k, other), std::min(k, other)) += A.value[s];
        }
    for (const auto& each : parts_) {
        const auto& block = each.factor.lastBlock();
        const auto& own = each.shared;
        for (std::size_t b = 0; b < own.size(); ++b)
            for (std::size_t a = 0; a < own.size(); ++a)
                if (own[a] >= own[b]) between_(own[a], own[b]) += block(a, b);
    }
    if (!factorColumns(between_.data(), n, n))
        throw StepFailure("matrix factorisation failed: a pivot vanishes or is not finite");
}

template <int Dim, class Stored, class Real>
Eigen::VectorXd DissectedLdlt<Dim, Stored, Real>::solve(const Eigen::VectorXd& b) const {
    const int nParts = static_cast<int>(parts_.size());
    std::vector<Eigen::VectorXd> own(nParts);
    parallelTasks(nParts, [&](int p) {
        const Part& part = parts_[p];
        if (part.interior.empty()) return;
        own[p] = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(part.interior.size() + part.shared.size()));
        for (std::size_t f = 0; f < part.interior.size(); ++f) own[p][f] = b[part.interior[f]];
        part.factor.eliminate(own[p]);
    });
    Eigen::VectorXd shared(static_cast<Eigen::Index>(shared_.size()));
    for (std::size_t k = 0; k < shared_.size(); ++k) shared[k] = b[shared_[k]];
    for (int p = 0; p < nParts; ++p)
        for (std::size_t k = 0; k < parts_[p].shared.size(); ++k)
            shared[parts_[p].shared[k]] += own[p][parts_[p].interior.size() + k];
    if (!shared_.empty()) {
        between_.triangularView<Eigen::UnitLower>().solveInPlace(shared);
        shared.array() /= between_.diagonal().array();
        between_.transpose().triangularView<Eigen::UnitUpper>().solveInPlace(shared);
    }

    Eigen::VectorXd x(b.size());
    for (std::size_t k = 0; k < shared_.size(); ++k) x[shared_[k]] = shared[k];
    parallelTasks(nParts, [&](int p) {
        const Part& part = parts_[p];
        if (part.interior.empty()) return;
        for (std::size_t k = 0; k < part.shared.size(); ++k) own[p][part.interior.size() + k] = shared[part.shared[k]];
        part.factor.backSubstitute(own[p]);
        for (std::size_t f = 0; f < part.interior.size(); ++f) x[part.interior[f]] = own[p][f];
    });
    return x;
}

std::vector<unsigned char> sharedUnknowns(const SymmetricMatrix& A, const std::vector<int>& part) {
    std::vector<unsigned char> shared(A.n, 0);
    for (int j = 0; j < A.n; ++j)
        for (int s = A.start[j]; s < A.start[j + 1]; ++s) {
            const int i = A.row[s];
            if (part[i] != part[j]) shared[part[i] < part[j] ? i : j] = 1;
        }
    return shared;
}

template <int Dim>
std::vector<int> slabs(const Places<Dim>& place, int nParts, int axis, int nShared) {
    std::vector<int> part(place.size(), 0);
    if (place.empty() || nParts < 2) return part;
    std::vector<double> sorted;
    for (const auto& x : place) sorted.push_back(x[axis]);
    std::vector<double> cuts;
    for (int k = 1; k < nParts; ++k) {
        const std::size_t below = (sorted.size() + nShared) * k / nParts;
        const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::min(below, sorted.size() - 1));
        std::nth_element(sorted.begin(), nth, sorted.end());
        cuts.push_back(*nth);
    }
    for (std::size_t i = 0; i < place.size(); ++i)
        part[i] = static_cast<int>(std::upper_bound(cuts.begin(), cuts.end(), place[i][axis]) - cuts.begin());
    return part;
}

#define PFEM_INSTANTIATE(D)                          \
    template class DissectedLdlt<D, float, float>;   \
    template class DissectedLdlt<D, float, double>;  \
    template class DissectedLdlt<D, double, double>; \
    template std::vector<int> slabs<D>(const Places<D>&, int, int, int);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
