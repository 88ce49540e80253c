#include "linear/ldlt.hpp"

#include <cholmod.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"

namespace pfem {

namespace {

/// Are all pivots numbers? CHOLMOD itself goes on with those that are not.
bool isFinite(const cholmod_factor& L) {
    const auto* start = static_cast<const int*>(L.p);
    const auto* value = static_cast<const double*>(L.x);
    for (std::size_t j = 0; j < L.n; ++j)
        if (!std::isfinite(value[start[j]])) return false;
    return true;
}

}  // namespace

struct Ldlt::Cholmod {
    cholmod_common common;
    cholmod_factor* factor = nullptr;
    int nLast = 0;

    Cholmod() {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SIMPLICIAL;  // LL^T would need positive definiteness
        common.final_ll = 0;
        common.nmethods = 1;
        common.print = 0;
        common.error_handler = nullptr;
    }
    ~Cholmod() {
        if (factor) cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;

    void analyze(cholmod_sparse& A) {
        if (factor) cholmod_free_factor(&factor, &common);
        factor = cholmod_analyze(&A, &common);
        if (!factor) throw StepFailure("matrix analysis failed (out of memory?)");
    }
    void factorize(cholmod_sparse& A) {
        cholmod_factorize(&A, factor, &common);
        if (common.status < CHOLMOD_OK || factor->minor < factor->n || !isFinite(*factor))
            throw StepFailure("matrix factorisation failed: a pivot vanishes or is not finite");
    }
};

namespace {

/// A view of a triangle for CHOLMOD, by columns; nothing is copied or changed.
cholmod_sparse view(int n, const std::vector<int>& start, const std::vector<int>& index, const std::vector<double>& value) {
    cholmod_sparse s{};
    s.nrow = s.ncol = static_cast<std::size_t>(n);
    s.nzmax = index.size();
    s.p = const_cast<int*>(start.data());
    s.i = const_cast<int*>(index.data());
    s.x = const_cast<double*>(value.data());
    s.itype = CHOLMOD_INT;
    s.xtype = CHOLMOD_REAL;
    s.dtype = CHOLMOD_DOUBLE;
    s.packed = 1;
    return s;
}

cholmod_sparse view(const SymmetricMatrix& A) {
    cholmod_sparse s = view(A.n, A.start, A.row, A.value);
    s.stype = -1;
    s.sorted = 1;
    return s;
}

/// Rows of the lower triangle are columns of the upper one: the form that CHOLMOD factors without a copy.
cholmod_sparse view(const LowerRows& A) {
    cholmod_sparse s = view(A.n, A.start, A.column, A.value);
    s.stype = 1;
    return s;
}

/// The columns of a simplicial factor, diagonal D first.
struct Columns {
    const int *start, *count, *row, *order;
    const double* value;
    int n;

    explicit Columns(const cholmod_factor& L)
        : start(static_cast<const int*>(L.p)),
          count(static_cast<const int*>(L.nz)),
          row(static_cast<const int*>(L.i)),
          order(static_cast<const int*>(L.Perm)),
          value(static_cast<const double*>(L.x)),
          n(static_cast<int>(L.n)) {}
};

}  // namespace

Ldlt::Ldlt() : cholmod_(std::make_unique<Cholmod>()) {}
Ldlt::~Ldlt() = default;
Ldlt::Ldlt(Ldlt&&) noexcept = default;
Ldlt& Ldlt::operator=(Ldlt&&) noexcept = default;

void Ldlt::analyze(const SymmetricMatrix& A) {
    auto& c = *cholmod_;
    cholmod_sparse s = view(A);
    c.nLast = 0;
    c.common.method[0].ordering = CHOLMOD_AMD;
    c.common.postorder = 1;
    c.analyze(s);
}

void Ldlt::factorize(const SymmetricMatrix& A) {
    cholmod_sparse s = view(A);
    cholmod_->factorize(s);
}

void Ldlt::factorize(const LowerRows& A, int nLast) {
    auto& c = *cholmod_;
    cholmod_sparse s = view(A);
    c.nLast = nLast;
    c.common.method[0].ordering = CHOLMOD_NATURAL;
    c.common.postorder = 0;  // it would mix the last ones with the others
    c.analyze(s);
    c.factorize(s);
}

Eigen::VectorXd Ldlt::solve(const Eigen::VectorXd& b) const {
    auto& c = *cholmod_;
    cholmod_dense rhs{};
    rhs.nrow = rhs.d = rhs.nzmax = c.factor->n;
    rhs.ncol = 1;
    rhs.x = const_cast<double*>(b.data());
    rhs.xtype = CHOLMOD_REAL;
    rhs.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, c.factor, &rhs, &c.common);
    if (!solution) throw StepFailure("linear solution failed");
    Eigen::VectorXd x = Eigen::Map<Eigen::VectorXd>(static_cast<double*>(solution->x), b.size());
    cholmod_free_dense(&solution, &c.common);
    return x;
}

Eigen::MatrixXd Ldlt::lastBlock() const {
    const Columns L(*cholmod_->factor);
    const int nLast = cholmod_->nLast, first = L.n - nLast;
    // sum_j l_j d_j l_j^T
    Eigen::MatrixXd l = Eigen::MatrixXd::Zero(nLast, nLast), ld = l, block(nLast, nLast);
    for (int j = first; j < L.n; ++j) {
        const double d = L.value[L.start[j]];
        l(L.order[j] - first, j - first) = 1;
        ld(L.order[j] - first, j - first) = d;
        for (int s = L.start[j] + 1; s < L.start[j] + L.count[j]; ++s) {
            l(L.order[L.row[s]] - first, j - first) = L.value[s];
            ld(L.order[L.row[s]] - first, j - first) = d * L.value[s];
        }
    }
    block.triangularView<Eigen::Lower>() = ld * l.transpose();
    block.triangularView<Eigen::StrictlyUpper>() = block.transpose();
    return block;
}

void Ldlt::eliminate(Eigen::VectorXd& b) const {
    const Columns L(*cholmod_->factor);
    std::vector<double> w(L.n);
    for (int j = 0; j < L.n; ++j) w[j] = b[L.order[j]];
    for (int j = 0; j < L.n - cholmod_->nLast; ++j)
        for (int s = L.start[j] + 1; s < L.start[j] + L.count[j]; ++s) w[L.row[s]] -= L.value[s] * w[j];
    for (int j = 0; j < L.n; ++j) b[L.order[j]] = w[j];
}

void Ldlt::backSubstitute(Eigen::VectorXd& x) const {
    const Columns L(*cholmod_->factor);
    std::vector<double> w(L.n);
    for (int j = 0; j < L.n; ++j) w[j] = x[L.order[j]];
    for (int j = L.n - cholmod_->nLast - 1; j >= 0; --j) {
        w[j] /= L.value[L.start[j]];
        for (int s = L.start[j] + 1; s < L.start[j] + L.count[j]; ++s) w[j] -= L.value[s] * w[L.row[s]];
    }
    for (int j = 0; j < L.n; ++j) x[L.order[j]] = w[j];
}

std::vector<int> minimumDegree(const MatrixGraph& graph) {
    const std::size_t n = graph.start.size() - 1;
    std::vector<int> order(n);
    if (n == 0) return order;
    cholmod_sparse A{};
    A.nrow = A.ncol = n;
    A.nzmax = graph.neighbour.size();
    A.p = const_cast<int*>(graph.start.data());
    A.i = const_cast<int*>(graph.neighbour.data());
    A.stype = 1;  // the other triangle says the same
    A.itype = CHOLMOD_INT;
    A.xtype = CHOLMOD_PATTERN;
    A.packed = 1;
    cholmod_common common;
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    const bool done = cholmod_amd(&A, nullptr, 0, order.data(), &common) != 0;
    cholmod_finish(&common);
    if (!done) throw StepFailure("matrix ordering failed (out of memory?)");
    return order;
}

}  // namespace pfem
