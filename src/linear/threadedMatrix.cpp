#include "linear/threadedMatrix.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace pfem {

namespace {

/// Rows of PETSc's, as long as this lives.
struct Rows {
    ::Mat A;
    PetscInt n = 0;
    const PetscInt *start = nullptr, *column = nullptr;
    const PetscScalar* value = nullptr;

    explicit Rows(::Mat matrix) : A(matrix) {
        PetscBool done = PETSC_FALSE;
        MatGetRowIJ(A, 0, PETSC_FALSE, PETSC_FALSE, &n, &start, &column, &done);
        MatSeqAIJGetArrayRead(A, &value);
    }
    ~Rows() {
        PetscBool done = PETSC_FALSE;
        MatSeqAIJRestoreArrayRead(A, &value);
        MatRestoreRowIJ(A, 0, PETSC_FALSE, PETSC_FALSE, &n, &start, &column, &done);
    }
    Rows(const Rows&) = delete;
    Rows& operator=(const Rows&) = delete;

    /// Entries first ... last - 1 times x, four at a time: each addition waits for the one before.
    double product(PetscInt first, PetscInt last, const PetscScalar* x) const {
        double sum = 0;
        PetscInt s = first;
        for (; s + 4 <= last; s += 4)
            sum += (value[s] * x[column[s]] + value[s + 1] * x[column[s + 1]]) +
                   (value[s + 2] * x[column[s + 2]] + value[s + 3] * x[column[s + 3]]);
        for (; s < last; ++s) sum += value[s] * x[column[s]];
        return sum;
    }
    /// Of row i with x.
    double product(PetscInt i, const PetscScalar* x) const { return product(start[i], start[i + 1], x); }
};

/// Blocks of rows that are swept at the same time, and which entries of each row are of its own block: from `own` to
/// before `next`, the diagonal between. Blocks know nothing of each other within a sweep: where many meet, in rows of
/// nodes that came late, sweeps overshoot, and the cycle is indefinite. `added` to the diagonal, half the sum of what
/// is of other blocks, in absolute values, makes twice the block D' larger than all of A: 2 D' - A = D + 2 E - O > 0,
/// for x.O x <= 2 x.E x, O the entries of other blocks (Baker, Falgout, Kolev, Yang 2011).
struct Blocks {
    struct Row {
        PetscInt own, diagonal, next;
        double added, inverse;  // the latter of the diagonal with it
    };
    std::vector<PetscInt> ends;
    std::vector<Row> rows;

    explicit Blocks(const Rows& A) : rows(A.n) {
        constexpr int leastRows = 200, mostBlocks = 8;
        const std::int64_t nBlocks = std::clamp(A.n / leastRows, 1, mostBlocks);
        for (std::int64_t block = 1; block <= nBlocks; ++block)
            ends.push_back(static_cast<PetscInt>(block * A.n / nBlocks));
        parallelTasks(size(), [&](int block) {
            for (PetscInt i = first(block); i < ends[block]; ++i) {
                const auto at = [&](PetscInt column) {
                    const auto* end = A.column + A.start[i + 1];
                    return static_cast<PetscInt>(std::lower_bound(A.column + A.start[i], end, column) - A.column);
                };
                Row& row = rows[i] = {at(first(block)), at(i), at(ends[block]), 0, 0};
                for (PetscInt s = A.start[i]; s < A.start[i + 1]; ++s)
                    if (s < row.own || s >= row.next) row.added += 0.5 * std::abs(A.value[s]);
                row.inverse = 1 / (A.value[row.diagonal] + row.added);
            }
        });
    }
    int size() const { return static_cast<int>(ends.size()); }
    PetscInt first(int block) const { return block == 0 ? 0 : ends[block - 1]; }
};

constexpr const char* blocksOfMatrix = "blocks";

/// PETSc keeps them with the matrix.
void keepBlocks(::Mat A) {
    PetscContainer container = nullptr;
    PetscContainerCreate(PETSC_COMM_SELF, &container);
    PetscContainerSetPointer(container, std::make_unique<Blocks>(Rows(A)).release());
    PetscContainerSetUserDestroy(container, [](void* blocks) {
        delete static_cast<Blocks*>(blocks);
        return PetscErrorCode(0);
    });
    PetscObjectCompose(reinterpret_cast<PetscObject>(A), blocksOfMatrix, reinterpret_cast<PetscObject>(container));
    PetscContainerDestroy(&container);
}

const Blocks& blocksOf(::Mat A) {
    PetscObject container = nullptr;
    void* blocks = nullptr;
    PetscObjectQuery(reinterpret_cast<PetscObject>(A), blocksOfMatrix, &container);
    PetscContainerGetPointer(reinterpret_cast<PetscContainer>(container), &blocks);
    return *static_cast<const Blocks*>(blocks);
}

/// Numbers of one of PETSc's vectors that are read.
struct Input {
    ::Vec vec;
    const PetscScalar* values = nullptr;

    explicit Input(::Vec x) : vec(x) { VecGetArrayRead(vec, &values); }
    ~Input() { VecRestoreArrayRead(vec, &values); }
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;
    const PetscScalar& operator[](PetscInt i) const { return values[i]; }
};

/// Those that are written.
struct Output {
    ::Vec vec;
    PetscScalar* values = nullptr;

    explicit Output(::Vec x) : vec(x) { VecGetArray(vec, &values); }
    ~Output() { VecRestoreArray(vec, &values); }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    PetscScalar& operator[](PetscInt i) const { return values[i]; }
};

PetscErrorCode multiply(::Mat A, ::Vec in, ::Vec out) {
    const Rows rows(A);
    const Input x(in);
    const Output y(out);
    parallelFor(rows.n, [&](int i) { y[i] = rows.product(i, x.values); });
    return 0;
}

/// PETSc passes one vector as both `given` and `out`, too.
PetscErrorCode multiplyAdd(::Mat A, ::Vec in, ::Vec given, ::Vec out) {
    const Rows rows(A);
    const Input x(in);
    if (given != out) VecCopy(given, out);
    const Output w(out);
    parallelFor(rows.n, [&](int i) { w[i] += rows.product(i, x.values); });
    return 0;
}

/// x += M^{-1} (b - A x), M: the symmetric sweep of each block, its diagonal with what is added to it.
class Sweep {
public:
    Sweep(::Mat A, ::Vec right, ::Vec out)
        : A_(A), blocks_(blocksOf(A)), b_(right), x_(out), old_(unset(A_.n)), t_(unset(A_.n)) {}

    void run(bool fromZero) {
        if (!fromZero) parallelFor(A_.n, [&](int i) { old_[i] = x_[i]; });
        parallelTasks(blocks_.size(), [&](int block) { sweepBlock(block, fromZero ? nullptr : old_.get()); });
    }

private:
    /// Numbers that are written before they are read.
    static std::unique_ptr<double[]> unset(PetscInt n) { return std::make_unique_for_overwrite<double[]>(n); }

    /// Forward and backward. `old`: what other rows have, and these before the sweep; null: zero.
    void sweepBlock(int block, const double* old) {
        const auto [first, last] = std::pair(blocks_.first(block), blocks_.ends[block]);
        PetscScalar* const x = x_.values;
        for (PetscInt i = first; i < last; ++i) {
            const Blocks::Row& row = blocks_.rows[i];
            double others = 0, above = 0;
            if (old) {
                others = A_.product(A_.start[i], row.own, old) + A_.product(row.next, A_.start[i + 1], old);
                above = A_.product(row.diagonal + 1, row.next, old);
            }
            t_[i] = b_[i] - others - A_.product(row.own, row.diagonal, x);
            if (old) t_[i] += row.added * old[i];
            x[i] = (t_[i] - above) * row.inverse;
        }
        for (PetscInt i = last; i-- > first;) {
            const Blocks::Row& row = blocks_.rows[i];
            x[i] = (t_[i] - A_.product(row.diagonal + 1, row.next, x)) * row.inverse;
        }
    }

    const Rows A_;
    const Blocks& blocks_;
    const Input b_;
    const Output x_;
    std::unique_ptr<double[]> old_, t_;  // t_: what is left of b below the diagonal
};

template <class Kernel>
void replace(::Mat A, MatOperation operation, Kernel* kernel) {
    MatSetOperation(A, operation, reinterpret_cast<void (*)()>(kernel));
}

}  // namespace

void multiplyByThreads(::Mat A) {
    replace(A, MATOP_MULT, multiply);
    replace(A, MATOP_MULT_ADD, multiplyAdd);
}

void cycleByThreads(::PC multigrid) {
    PetscInt nLevels = 0;
    PCMGGetLevels(multigrid, &nLevels);
    for (PetscInt level = 1; level < nLevels; ++level) {  // the coarsest has a factor
        KSP smoother = nullptr;
        ::Mat A = nullptr, prolongation = nullptr, restriction = nullptr;
        PCMGGetSmoother(multigrid, level, &smoother);
        KSPGetOperators(smoother, nullptr, &A);
        keepBlocks(A);
        replace(
            A, MATOP_SOR,
            +[](::Mat rows, ::Vec b, PetscReal, MatSORType type, PetscReal, PetscInt its, PetscInt, ::Vec x) {
                Sweep sweep(rows, b, x);
                for (PetscInt k = 0; k < its; ++k) sweep.run(k == 0 && (type & SOR_ZERO_INITIAL_GUESS));
                return PetscErrorCode(0);
            });
        PCMGGetInterpolation(multigrid, level, &prolongation);
        MatTranspose(prolongation, MAT_INITIAL_MATRIX, &restriction);
        PCMGSetRestriction(multigrid, level, restriction);
        for (const ::Mat matrix : {A, prolongation, restriction}) multiplyByThreads(matrix);
        MatDestroy(&restriction);
    }
}

}  // namespace pfem
