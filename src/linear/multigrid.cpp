#include "linear/multigrid.hpp"

#include <dlfcn.h>
#include <omp.h>
#include <petscksp.h>

#include <algorithm>
#include <future>

#include "base/error.hpp"
#include "linear/threadedMatrix.hpp"

namespace pfem {

namespace {

void check(PetscErrorCode code, const char* what) {
    if (code != 0) throw StepFailure(std::string("multigrid: PETSc fails in ") + what);
}

/// BLAS sums by one thread: else the bits would depend on the number of threads (OpenBLAS, from 10 000 numbers on).
void keepBlasSerial() {
    const auto setThreads = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
    if (setThreads) setThreads(1);
}

/// PETSc (and MPI below it) is started when it is needed first and ends with the program. Of the user's options it
/// reads those of the environment (PETSC_OPTIONS); it leaves signals alone: they stop a run in good order.
void startPetsc(bool isShared) {
    static const struct Session {
        explicit Session(bool byRanks) {
            keepBlasSerial();
            PETSC_MPI_THREAD_REQUIRED = MPI_THREAD_SERIALIZED;  // levels are made by a thread of their own
            PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
            check(PetscInitializeNoArguments(), "its start");
            PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_ksp_type", "richardson");
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_ksp_max_it", "1");
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_pc_type", "sor");
            // ranks: PETSc's own choice adds what comes from others in the order in which it arrives; one process: its
            // own choice is slower
            PetscOptionsSetValue(nullptr, "-matptap_via", byRanks ? "backend" : "rap");
        }
        ~Session() { PetscFinalize(); }
        Session(const Session&) = delete;
        Session& operator=(const Session&) = delete;
    } session(isShared);
}

/// A vector of PETSc's on numbers of ours, those of own rows.
class View {
public:
    View(const Eigen::VectorXd& x, const Ranks& ranks) {
        const auto n = static_cast<PetscInt>(x.size());
        check(ranks.isAlone() ? VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, x.data(), &vec_)
                              : VecCreateMPIWithArray(PETSC_COMM_WORLD, 1, n, PETSC_DECIDE, x.data(), &vec_),
              "a vector");
    }
    ~View() { VecDestroy(&vec_); }
    View(const View&) = delete;
    View& operator=(const View&) = delete;
    ::Vec get() const { return vec_; }

private:
    ::Vec vec_ = nullptr;
};

/// An operator on all unknowns.
struct WholeOperator {
    Multigrid::Operator apply;
    const RankRows& rows;

    Eigen::VectorXd operator()(const Eigen::VectorXd& own) const {
        const Eigen::VectorXd result = apply(rows.all(own));
        return result.segment(rows.begin(), own.size());
    }
};

/// y = apply(x), called by PETSc.
PetscErrorCode applyOperator(::Mat A, ::Vec x, ::Vec y) {
    void* context = nullptr;
    MatShellGetContext(A, &context);
    PetscInt n = 0;
    VecGetLocalSize(x, &n);
    const PetscScalar* from = nullptr;
    PetscScalar* to = nullptr;
    VecGetArrayRead(x, &from);
    VecGetArray(y, &to);
    Eigen::Map<Eigen::VectorXd>(to, n) =
        (*static_cast<const WholeOperator*>(context))(Eigen::Map<const Eigen::VectorXd>(from, n));
    VecRestoreArray(y, &to);
    VecRestoreArrayRead(x, &from);
    return 0;
}

}  // namespace

bool hasMultigrid() { return true; }

struct Multigrid::Petsc {
    RankRows shares;
    SparseRows rows;  // where one rank has all, PETSc's matrix has no copy of its own
    WholeOperator whole{{}, shares};
    ::Mat A = nullptr, shell = nullptr;
    KSP ksp = nullptr;
    std::future<void> levels;  // that are being made

    explicit Petsc(RankRows rowsOfRanks) : shares(std::move(rowsOfRanks)) {}
    Petsc(const Petsc&) = delete;
    Petsc& operator=(const Petsc&) = delete;
    ~Petsc() {
        clear();
        KSPDestroy(&ksp);
    }
    void clear() {
        levels = {};  // waits for them
        if (ksp) KSPReset(ksp);
        MatDestroy(&A);
        MatDestroy(&shell);
    }
    MPI_Comm communicator() const { return shares.ranks.isAlone() ? PETSC_COMM_SELF : PETSC_COMM_WORLD; }
    /// One process: with kernels that use threads.
    void makeLevels() {
        check(KSPSetUp(ksp), "the levels");
        if (!shares.ranks.isAlone()) return;
        PC pc = nullptr;
        KSPGetPC(ksp, &pc);
        cycleByThreads(pc);
    }
    /// PETSc's matrix of own rows, of n in all.
    void makeMatrix(SparseRows own, PetscInt n) {
        if (shares.ranks.isAlone()) {
            rows = std::move(own);
            check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, rows.start.data(), rows.column.data(),
                                            rows.value.data(), &A),
                  "a matrix");
            return;
        }
        check(MatCreateMPIAIJWithArrays(PETSC_COMM_WORLD, own.n(), own.n(), n, n, own.start.data(), own.column.data(),
                                        own.value.data(), &A),
              "a matrix");
    }
};

Multigrid::Multigrid(double tolerance, RankRows rows) : petsc_(std::make_unique<Petsc>(std::move(rows))) {
    startPetsc(!petsc_->shares.ranks.isAlone());
    KSP& ksp = petsc_->ksp;
    check(KSPCreate(petsc_->communicator(), &ksp), "a solver");
    KSPSetType(ksp, KSPCG);
    KSPSetTolerances(ksp, tolerance, 0, PETSC_DEFAULT, 500);
    PC pc = nullptr;
    KSPGetPC(ksp, &pc);
    PCSetType(pc, PCGAMG);
    PCSetUseAmat(pc, PETSC_FALSE);  // smooth with the matrix of the levels, not with the operator
    KSPSetOptionsPrefix(ksp, "pfem_");
    check(KSPSetFromOptions(ksp), "a solver's options");
}

Multigrid::~Multigrid() = default;

void Multigrid::setUp(SparseRows A, Operator apply) {
    Petsc& p = *petsc_;
    p.clear();
    p.whole.apply = std::move(apply);
    const PetscInt nRows = A.n(), n = p.shares.ranks.isAlone() ? nRows : static_cast<PetscInt>(p.shares.ends.back());
    p.makeMatrix(std::move(A), n);
    MatSetOption(p.A, MAT_SPD, PETSC_TRUE);
    if (p.shares.ranks.isAlone()) multiplyByThreads(p.A);
    if (p.whole.apply) {
        check(MatCreateShell(p.communicator(), nRows, nRows, n, n, &p.whole, &p.shell), "an operator");
        MatShellSetOperation(p.shell, MATOP_MULT, reinterpret_cast<void (*)()>(applyOperator));
        MatSetOption(p.shell, MAT_SPD, PETSC_TRUE);
    }
    check(KSPSetOperators(p.ksp, p.shell ? p.shell : p.A, p.A), "the operators");
    const bool beside = p.shares.ranks.isAlone() && omp_get_max_threads() > 1;
    p.levels = std::async(beside ? std::launch::async : std::launch::deferred, [&p, beside] {
        if (beside) omp_set_num_threads(1);  // of this thread
        p.makeLevels();
    });
}

Eigen::VectorXd Multigrid::solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    if (b.size() == 0 || (petsc_->shares.ranks.isAlone() && b.isZero(0))) return x;  // ranks see rows of their own
    if (petsc_->levels.valid()) petsc_->levels.get();
    const RankRows& rows = petsc_->shares;
    const bool isAlone = rows.ranks.isAlone();
    Eigen::VectorXd ownB, ownX;
    if (!isAlone) {
        ownB = b.segment(rows.begin(), rows.end(0) - rows.begin());
        ownX = Eigen::VectorXd::Zero(ownB.size());
    }
    const View from(isAlone ? b : ownB, rows.ranks), to(isAlone ? x : ownX, rows.ranks);
    check(KSPSolve(petsc_->ksp, from.get(), to.get()), "the iteration");
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    KSPGetConvergedReason(petsc_->ksp, &reason);
    if (reason <= 0)
        throw StepFailure(std::string("the linear iteration of the pressure does not converge: ") +
                          KSPConvergedReasons[reason]);
    return isAlone ? x : rows.all(ownX);
}

int Multigrid::iterations() const {
    PetscInt n = 0;
    KSPGetIterationNumber(petsc_->ksp, &n);
    return static_cast<int>(n);
}

}  // namespace pfem
