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

    void analyse(cholmod_sparse& A) {
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

/// A view for CHOLMOD; nothing is copied or changed.
cholmod_sparse view(const SymmetricMatrix& A) {
    cholmod_sparse s{};
    s.nrow = s.ncol = static_cast<std::size_t>(A.n);
    s.nzmax = A.row.size();
    s.p = const_cast<int*>(A.start.data());
    s.i = const_cast<int*>(A.row.data());
    s.x = const_cast<double*>(A.value.data());
    s.stype = -1;
    s.itype = CHOLMOD_INT;
    s.xtype = CHOLMOD_REAL;
    s.dtype = CHOLMOD_DOUBLE;
    s.sorted = 1;
    s.packed = 1;
    return s;
}

}  // namespace

Ldlt::Ldlt() : cholmod_(std::make_unique<Cholmod>()) {}
Ldlt::~Ldlt() = default;
Ldlt::Ldlt(Ldlt&&) noexcept = default;
Ldlt& Ldlt::operator=(Ldlt&&) noexcept = default;

void Ldlt::analyse(const SymmetricMatrix& A) {
    auto& c = *cholmod_;
    cholmod_sparse s = view(A);
    c.common.method[0].ordering = CHOLMOD_AMD;
    c.common.postorder = 1;
    c.analyse(s);
}

void Ldlt::factor(const SymmetricMatrix& A) {
    cholmod_sparse s = view(A);
    cholmod_->factorize(s);
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

}  // namespace pfem
