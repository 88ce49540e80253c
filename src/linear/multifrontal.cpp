#include "linear/multifrontal.hpp"

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "linear/denseFront.hpp"
#include "linear/flushToZero.hpp"

namespace pfem {

namespace {

/// What fronts leave to their parents, in the order of the fronts: packed lower triangles, the latest on top.
template <class Real>
class Remainders {
public:
    int front() const { return fronts_.back(); }  // whose remainder is on top
    const Real* top(int r) const { return stack_.data() + top_ - packedSize(r); }
    void pop(int r) {
        top_ -= packedSize(r);
        fronts_.pop_back();
    }

    /// r rows of zeros above the top, not yet of the stack; what is below stays where it is until push().
    Real* fresh(int r) {
        fresh_ = top_;
        if (stack_.size() < top_ + packedSize(r)) stack_.resize(std::max(2 * stack_.size(), top_ + packedSize(r)));
        std::fill_n(stack_.data() + fresh_, packedSize(r), 0.0);
        return stack_.data() + fresh_;
    }
    void push(int front, int r) {
        fronts_.push_back(front);
        if (fresh_ != top_) std::copy_n(stack_.data() + fresh_, packedSize(r), stack_.data() + top_);
        top_ += packedSize(r);
    }

private:
    std::vector<Real> stack_;
    std::vector<int> fronts_;
    std::size_t top_ = 0, fresh_ = 0;
};

/// A front while it is put together: `width` columns of m rows, and the remainder of the others.
template <class Real>
struct OpenFront {
    Real* F;
    Real* U;
    int m, width;
};

/// Add what a child leaves to its parent. `rows`: the n of the child; `place`: of each row in the parent.
template <class Real>
void takeUp(const Real* source, const int* rows, int n, const std::vector<int>& place, const OpenFront<Real>& parent) {
    const auto& [F, U, m, width] = parent;
    const int r = m - width;
    for (int a = 0; a < n; ++a) {
        const int at = place[rows[a]];
        Real* const target =
            at < width ? F + static_cast<std::size_t>(at) * m : U + packedColumn(at - width, r) - width;
        for (int b = a; b < n; ++b) target[place[rows[b]]] += *source++;
    }
}

}  // namespace

template <class Stored, class Real>
void Multifrontal<Stored, Real>::factorize(const LowerColumns& A, const std::vector<Piece>& pieces) {
    fronts_ = makeFronts(A, pieces);
    const int n = A.nColumns(), nLast = A.n - n;
    start_.assign(1, 0);
    std::size_t largest = 0;
    for (const Front& front : fronts_.front) {
        const auto size = static_cast<std::size_t>(front.width) * (front.width + front.nRows);
        start_.push_back(start_.back() + size);
        largest = std::max(largest, size);
    }
    values_.resize(static_cast<Eigen::Index>(start_.back()));
    lastBlock_ = Eigen::MatrixXd::Zero(nLast, nLast);

    std::optional<FlushToZero> flush;
    if (sizeof(Real) == sizeof(float)) flush.emplace();
    Remainders<Real> remainders;
    std::vector<Real> block(largest);
    Real* const F = block.data();
    std::vector<int> place(A.n);  // of a label in the present front
    for (std::size_t f = 0; f < fronts_.front.size(); ++f) {
        const Front& front = fronts_.front[f];
        const int* const rows = fronts_.rowsOf(front);
        const int width = front.width, r = front.nRows, m = width + r;
        std::fill_n(F, static_cast<std::size_t>(width) * m, 0.0);
        Real* const U = remainders.fresh(r);
        for (int k = 0; k < width; ++k) place[front.first + k] = k;
        for (int k = 0; k < r; ++k) place[rows[k]] = width + k;
        for (int k = 0; k < width; ++k)
            for (int s = A.start[front.first + k]; s < A.start[front.first + k + 1]; ++s)
                F[static_cast<std::size_t>(k) * m + place[A.row[s]]] += static_cast<Real>(A.value[s]);
        for (int c = 0; c < front.nChildren; ++c) {
            const Front& child = fronts_.front[remainders.front()];
            takeUp(remainders.top(child.nRows), fronts_.rowsOf(child), child.nRows, place,
                   OpenFront<Real>{F, U, m, width});
            remainders.pop(child.nRows);
        }
        if (!factorColumns(F, m, width))
            throw StepFailure("matrix factorisation failed: a pivot vanishes or is not finite");
        subtractProduct(U, r, F, m, width);
        std::copy_n(F, static_cast<std::size_t>(m) * width, values_.data() + start_[f]);
        if (r > 0 && rows[0] < n) {
            remainders.push(static_cast<int>(f), r);
            continue;
        }
        for (int a = 0; a < r; ++a)
            for (int b = a; b < r; ++b) lastBlock_(rows[b] - n, rows[a] - n) += U[packedColumn(a, r) + b];
    }
    lastBlock_.triangularView<Eigen::StrictlyUpper>() = lastBlock_.transpose();
}

template <class Stored, class Real>
void Multifrontal<Stored, Real>::eliminate(Eigen::VectorXd& b) const {
    double* const w = b.data();
    std::vector<double> below;
    for (std::size_t f = 0; f < fronts_.front.size(); ++f) {
        const Front& front = fronts_.front[f];
        const int* const rows = fronts_.rowsOf(front);
        below.assign(front.nRows, 0.0);
        eliminateColumns(values_.data() + start_[f], front.width + front.nRows, front.width, w + front.first,
                         below.data());
        for (int i = 0; i < front.nRows; ++i) w[rows[i]] -= below[i];
    }
}

template <class Stored, class Real>
void Multifrontal<Stored, Real>::backSubstitute(Eigen::VectorXd& x) const {
    double* const w = x.data();
    std::vector<double> below;
    for (std::size_t f = fronts_.front.size(); f-- > 0;) {
        const Front& front = fronts_.front[f];
        const int* const rows = fronts_.rowsOf(front);
        below.resize(front.nRows);
        for (int i = 0; i < front.nRows; ++i) below[i] = w[rows[i]];
        substituteColumns(values_.data() + start_[f], front.width + front.nRows, front.width, below.data(),
                          w + front.first);
    }
}

template class Multifrontal<float, float>;
template class Multifrontal<float, double>;
template class Multifrontal<double, double>;

}  // namespace pfem
