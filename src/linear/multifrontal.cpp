#include "linear/multifrontal.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "linear/denseFront.hpp"

namespace pfem {

namespace {

/// What fronts leave to their parents, in the order of the fronts: r x r lower triangles, the latest on top.
class Remainders {
public:
    /// Room for r x r zeros that is not yet on the stack.
    double* fresh(int r) {
        fresh_.assign(static_cast<std::size_t>(r) * r, 0.0);
        return fresh_.data();
    }
    int front() const { return fronts_.back(); }  // whose remainder is on top
    const double* top(int r) const { return stack_.data() + top_ - static_cast<std::size_t>(r) * r; }
    void pop(int r) {
        top_ -= static_cast<std::size_t>(r) * r;
        fronts_.pop_back();
    }
    void push(int front, int r) {
        fronts_.push_back(front);
        const std::size_t size = static_cast<std::size_t>(r) * r;
        if (stack_.size() < top_ + size) stack_.resize(std::max(2 * stack_.size(), top_ + size));
        std::copy_n(fresh_.data(), size, stack_.data() + top_);
        top_ += size;
    }

private:
    std::vector<double> stack_, fresh_;
    std::vector<int> fronts_;
    std::size_t top_ = 0;
};

}  // namespace

void Multifrontal::factorize(const LowerColumns& A, const std::vector<Piece>& pieces) {
    fronts_ = makeFronts(A, pieces);
    const int n = A.nColumns(), nLast = A.n - n;
    start_.assign(1, 0);
    for (const Front& front : fronts_.front)
        start_.push_back(start_.back() + static_cast<std::size_t>(front.width) * (front.width + front.nRows));
    values_.assign(start_.back(), 0.0);
    lastBlock_ = Eigen::MatrixXd::Zero(nLast, nLast);

    Remainders remainders;
    std::vector<int> place(A.n);  // of a label in the present front
    for (std::size_t f = 0; f < fronts_.front.size(); ++f) {
        const Front& front = fronts_.front[f];
        const int* const rows = fronts_.rowsOf(front);
        const int width = front.width, r = front.nRows, m = width + r;
        double* const F = values_.data() + start_[f];
        double* const U = remainders.fresh(r);
        for (int k = 0; k < width; ++k) place[front.first + k] = k;
        for (int k = 0; k < r; ++k) place[rows[k]] = width + k;
        for (int k = 0; k < width; ++k)
            for (int s = A.start[front.first + k]; s < A.start[front.first + k + 1]; ++s)
                F[static_cast<std::size_t>(k) * m + place[A.row[s]]] += A.value[s];
        for (int c = 0; c < front.nChildren; ++c) {
            const Front& child = fronts_.front[remainders.front()];
            const int* const rowsOfChild = fronts_.rowsOf(child);
            const double* source = remainders.top(child.nRows);
            for (int a = 0; a < child.nRows; ++a, source += child.nRows) {
                const int at = place[rowsOfChild[a]];
                double* const target = at < width ? F + static_cast<std::size_t>(at) * m
                                                  : U + static_cast<std::size_t>(at - width) * r - width;
                for (int b = a; b < child.nRows; ++b) target[place[rowsOfChild[b]]] += source[b];
            }
            remainders.pop(child.nRows);
        }
        if (!factorColumns(F, m, width))
            throw StepFailure("matrix factorisation failed: a pivot vanishes or is not finite");
        subtractProduct(U, r, F, m, width);
        if (r > 0 && rows[0] < n) {
            remainders.push(static_cast<int>(f), r);
            continue;
        }
        for (int a = 0; a < r; ++a)
            for (int b = a; b < r; ++b) lastBlock_(rows[b] - n, rows[a] - n) += U[static_cast<std::size_t>(a) * r + b];
    }
    lastBlock_.triangularView<Eigen::StrictlyUpper>() = lastBlock_.transpose();
}

void Multifrontal::eliminate(Eigen::VectorXd& b) const {
    double* const w = b.data();
    std::vector<double> below;
    for (std::size_t f = 0; f < fronts_.front.size(); ++f) {
        const Front& front = fronts_.front[f];
        const int* const rows = fronts_.rowsOf(front);
        const int width = front.width, r = front.nRows, m = width + r;
        const double* column = values_.data() + start_[f];
        double* const own = w + front.first;
        below.assign(r, 0.0);
        for (int k = 0; k < width; ++k, column += m) {
            const double y = own[k];
            for (int i = k + 1; i < width; ++i) own[i] -= column[i] * y;
            for (int i = 0; i < r; ++i) below[i] += column[width + i] * y;
        }
        for (int i = 0; i < r; ++i) w[rows[i]] -= below[i];
    }
}

void Multifrontal::backSubstitute(Eigen::VectorXd& x) const {
    double* const w = x.data();
    std::vector<double> below;
    for (std::size_t f = fronts_.front.size(); f-- > 0;) {
        const Front& front = fronts_.front[f];
        const int* const rows = fronts_.rowsOf(front);
        const int width = front.width, r = front.nRows, m = width + r;
        const double* const block = values_.data() + start_[f];
        double* const own = w + front.first;
        below.resize(r);
        for (int i = 0; i < r; ++i) below[i] = w[rows[i]];
        for (int k = width - 1; k >= 0; --k) {
            const double* const column = block + static_cast<std::size_t>(k) * m;
            double sum = 0;
            for (int i = k + 1; i < width; ++i) sum += column[i] * own[i];
            for (int i = 0; i < r; ++i) sum += column[width + i] * below[i];
            own[k] = own[k] / column[k] - sum;
        }
    }
}

}  // namespace pfem
