#include "linear/rankMultigrid.hpp"

#include <dlfcn.h>
#include <petscksp.h>

#include "base/error.hpp"

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

/// PETSc is started when it is needed first and ends with the program. Of the user's options it reads those of the
/// environment (PETSC_OPTIONS); it leaves signals alone: they stop a run in good order.
void startPetsc() {
    static const struct Session {
        Session() {
            keepBlasSerial();
            PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
            check(PetscInitializeNoArguments(), "its start");
            PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_ksp_type", "richardson");
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_ksp_max_it", "1");
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_pc_type", "sor");
            // PETSc's own choice adds what comes from others in the order in which it arrives
            PetscOptionsSetValue(nullptr, "-matptap_via", "backend");
        }
        ~Session() { PetscFinalize(); }
        Session(const Session&) = delete;
        Session& operator=(const Session&) = delete;
    } session;
}

/// A vector of PETSc's on numbers of ours, those of own rows.
class View {
public:
    explicit View(const Eigen::VectorXd& x) {
        const auto n = static_cast<PetscInt>(x.size());
        check(VecCreateMPIWithArray(PETSC_COMM_WORLD, 1, n, PETSC_DECIDE, x.data(), &vec_), "a vector");
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
    IterativeSolver::Operator apply;
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

class RankMultigrid : public IterativeSolver {
public:
    RankMultigrid(double tolerance, RankRows rows) : rows_(std::move(rows)) {
        startPetsc();
        check(KSPCreate(PETSC_COMM_WORLD, &ksp_), "a solver");
        KSPSetType(ksp_, KSPCG);
        KSPSetTolerances(ksp_, tolerance, 0, PETSC_DEFAULT, 500);
        PC pc = nullptr;
        KSPGetPC(ksp_, &pc);
        PCSetType(pc, PCGAMG);
        PCSetUseAmat(pc, PETSC_FALSE);  // smooth with the matrix of the levels, not with the operator
        KSPSetOptionsPrefix(ksp_, "pfem_");
        check(KSPSetFromOptions(ksp_), "a solver's options");
    }
    ~RankMultigrid() override {
        clear();
        KSPDestroy(&ksp_);
    }
    RankMultigrid(const RankMultigrid&) = delete;
    RankMultigrid& operator=(const RankMultigrid&) = delete;

    void setUp(SparseRows own, Operator apply) override {
        clear();
        whole_.apply = std::move(apply);
        const PetscInt nOwn = own.n(), n = static_cast<PetscInt>(rows_.ends.back());
        check(MatCreateMPIAIJWithArrays(PETSC_COMM_WORLD, nOwn, nOwn, n, n, own.start.data(), own.column.data(),
                                        own.value.data(), &A_),
              "a matrix");
        MatSetOption(A_, MAT_SPD, PETSC_TRUE);
        if (whole_.apply) {
            check(MatCreateShell(PETSC_COMM_WORLD, nOwn, nOwn, n, n, &whole_, &shell_), "an operator");
            MatShellSetOperation(shell_, MATOP_MULT, reinterpret_cast<void (*)()>(applyOperator));
            MatSetOption(shell_, MAT_SPD, PETSC_TRUE);
        }
        check(KSPSetOperators(ksp_, shell_ ? shell_ : A_, A_), "the operators");
        check(KSPSetUp(ksp_), "the levels");
    }

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override {
        if (b.size() == 0) return b;
        const int n = static_cast<int>(rows_.ends.back());
        const Eigen::VectorXd ownB = b.segment(rows_.begin(), rows_.end(n) - rows_.begin());
        const Eigen::VectorXd ownX = Eigen::VectorXd::Zero(ownB.size());
        const View from(ownB), to(ownX);
        check(KSPSolve(ksp_, from.get(), to.get()), "the iteration");
        KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
        KSPGetConvergedReason(ksp_, &reason);
        if (reason <= 0)
            throw StepFailure(std::string("the linear iteration of the pressure does not converge: ") +
                              KSPConvergedReasons[reason]);
        return rows_.all(ownX);
    }

    int iterations() const override {
        PetscInt n = 0;
        KSPGetIterationNumber(ksp_, &n);
        return static_cast<int>(n);
    }

private:
    void clear() {
        if (ksp_) KSPReset(ksp_);
        MatDestroy(&A_);
        MatDestroy(&shell_);
    }

    RankRows rows_;
    WholeOperator whole_{{}, rows_};
    ::Mat A_ = nullptr, shell_ = nullptr;
    KSP ksp_ = nullptr;
};

}  // namespace

std::unique_ptr<IterativeSolver> rankMultigrid(double tolerance, RankRows rows) {
    return std::make_unique<RankMultigrid>(tolerance, std::move(rows));
}

}  // namespace pfem
