#pragma once
// Direct solvers of others behind the same interface, for comparison: CHOLMOD as it comes (with SuiteSparse's choice of
// order and of the factor's form), and MUMPS where it is installed.

#include <cholmod.h>
#ifdef PFEM_MUMPS
#include <dmumps_c.h>
#endif

#include <memory>
#include <vector>

#include "base/error.hpp"
#include "linear/symmetricSolver.hpp"

namespace pfem::test {

/// CHOLMOD's defaults: L D L^T column by column for small matrices, supernodal L L^T for large ones, which must then be
/// positive definite.
class Cholmod : public SymmetricSolver {
public:
    Cholmod() { cholmod_start(&common_); }
    ~Cholmod() override {
        cholmod_free_factor(&factor_, &common_);
        cholmod_finish(&common_);
    }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;

    void analyse(const SymmetricMatrix& A) override {
        cholmod_sparse view = viewOf(A);
        cholmod_free_factor(&factor_, &common_);
        factor_ = cholmod_analyze(&view, &common_);
    }
    void factor(const SymmetricMatrix& A) override {
        cholmod_sparse view = viewOf(A);
        cholmod_factorize(&view, factor_, &common_);
        if (common_.status < CHOLMOD_OK || factor_->minor < factor_->n) throw StepFailure("CHOLMOD: no factor");
    }
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override {
        cholmod_dense rhs{};
        rhs.nrow = rhs.d = rhs.nzmax = static_cast<std::size_t>(b.size());
        rhs.ncol = 1;
        rhs.x = const_cast<double*>(b.data());
        rhs.xtype = CHOLMOD_REAL;
        cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor_, &rhs, &common_);
        Eigen::VectorXd solution = Eigen::Map<Eigen::VectorXd>(static_cast<double*>(x->x), b.size());
        cholmod_free_dense(&x, &common_);
        return solution;
    }

private:
    static cholmod_sparse viewOf(const SymmetricMatrix& A) {
        cholmod_sparse view{};
        view.nrow = view.ncol = static_cast<std::size_t>(A.n);
        view.nzmax = A.row.size();
        view.p = const_cast<int*>(A.start.data());
        view.i = const_cast<int*>(A.row.data());
        view.x = const_cast<double*>(A.value.data());
        view.stype = -1;
        view.itype = CHOLMOD_INT;
        view.xtype = CHOLMOD_REAL;
        view.sorted = view.packed = 1;
        return view;
    }

    mutable cholmod_common common_{};
    cholmod_factor* factor_ = nullptr;
};

#ifdef PFEM_MUMPS
/// L D L^T with pivots of one and two columns: for any symmetric matrix.
class Mumps : public SymmetricSolver {
public:
    Mumps() {
        id_.par = 1;
        id_.sym = 2;
        id_.comm_fortran = -987654;  // MUMPS's word for "all processes"
        call(-1);
        for (const int k : {1, 2, 3, 4}) id_.icntl[k - 1] = k == 4 ? 0 : -1;  // silent
    }
    ~Mumps() override {
        id_.job = -2;
        dmumps_c(&id_);
    }
    Mumps(const Mumps&) = delete;
    Mumps& operator=(const Mumps&) = delete;

    void analyse(const SymmetricMatrix& A) override {
        row_.clear();
        column_.clear();
        for (int j = 0; j < A.n; ++j)
            for (int s = A.start[j]; s < A.start[j + 1]; ++s) {
                row_.push_back(A.row[s] + 1);
                column_.push_back(j + 1);
            }
        id_.n = A.n;
        id_.nnz = static_cast<MUMPS_INT8>(row_.size());
        id_.irn = row_.data();
        id_.jcn = column_.data();
        call(1);
    }
    void factor(const SymmetricMatrix& A) override {
        value_ = A.value;
        id_.a = value_.data();
        call(2);
    }
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override {
        Eigen::VectorXd x = b;
        id_.rhs = x.data();
        call(3);
        return x;
    }

private:
    void call(int job) const {
        id_.job = job;
        dmumps_c(&id_);
        if (id_.infog[0] < 0) throw StepFailure("MUMPS: error " + std::to_string(id_.infog[0]));
    }

    mutable DMUMPS_STRUC_C id_{};
    std::vector<MUMPS_INT> row_, column_;
    std::vector<double> value_;
};
#endif

}  // namespace pfem::test
