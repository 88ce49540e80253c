#include "linear/multigrid.hpp"

#include <petscksp.h>

#include "base/error.hpp"

namespace pfem {

namespace {

void check(PetscErrorCode code, const char* what) {
    if (code != 0) throw StepFailure(std::string("multigrid: PETSc fails in ") + what);
}

/// PETSc (and MPI below it) is started when it is needed first and ends with the program. It reads no options of the
/// user's and leaves signals alone: they stop a run in good order.
void startPetsc() {
    static const struct Session {
        Session() {
            PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
            check(PetscInitializeNoArguments(), "its start");
            PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_ksp_type", "richardson");
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_ksp_max_it", "1");
            PetscOptionsSetValue(nullptr, "-pfem_mg_levels_pc_type", "sor");
        }
        ~Session() { PetscFinalize(); }
        Session(const Session&) = delete;
        Session& operator=(const Session&) = delete;
    } session;
}

/// A vector of PETSc's on numbers of ours.
class View {
public:
    explicit View(const Eigen::VectorXd& x) {
        check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, static_cast<PetscInt>(x.size()), x.data(), &vec_), "a vector");
    }
    ~View() { VecDestroy(&vec_); }
    View(const View&) = delete;
    View& operator=(const View&) = delete;
    ::Vec get() const { return vec_; }

private:
    ::Vec vec_ = nullptr;
};

/// y = apply(x), called by PETSc.
PetscErrorCode applyOperator(::Mat A, ::Vec x, ::Vec y) {
    void* context = nullptr;
    MatShellGetContext(A, &context);
    PetscInt n = 0;
    VecGetSize(x, &n);
    const PetscScalar* from = nullptr;
    PetscScalar* to = nullptr;
    VecGetArrayRead(x, &from);
    VecGetArray(y, &to);
    Eigen::Map<Eigen::VectorXd>(to, n) =
        (*static_cast<Multigrid::Operator*>(context))(Eigen::Map<const Eigen::VectorXd>(from, n));
    VecRestoreArray(y, &to);
    VecRestoreArrayRead(x, &from);
    return 0;
}

}  // namespace

bool hasMultigrid() { return true; }

struct Multigrid::Petsc {
    SparseRows rows;  // PETSc's matrix has no copy of its own
    Operator apply;
    ::Mat A = nullptr, shell = nullptr;
    KSP ksp = nullptr;

    ~Petsc() {
        clear();
        KSPDestroy(&ksp);
    }
    void clear() {
        if (ksp) KSPReset(ksp);
        MatDestroy(&A);
        MatDestroy(&shell);
    }
};

Multigrid::Multigrid(double tolerance) : petsc_(std::make_unique<Petsc>()) {
    startPetsc();
    KSP& ksp = petsc_->ksp;
    check(KSPCreate(PETSC_COMM_SELF, &ksp), "a solver");
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
    p.rows = std::move(A);
    p.apply = std::move(apply);
    const PetscInt n = p.rows.n();
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, p.rows.start.data(), p.rows.column.data(),
                                    p.rows.value.data(), &p.A),
          "a matrix");
    MatSetOption(p.A, MAT_SPD, PETSC_TRUE);
    if (p.apply) {
        check(MatCreateShell(PETSC_COMM_SELF, n, n, n, n, &p.apply, &p.shell), "an operator");
        MatShellSetOperation(p.shell, MATOP_MULT, reinterpret_cast<void (*)()>(applyOperator));
        MatSetOption(p.shell, MAT_SPD, PETSC_TRUE);
    }
    check(KSPSetOperators(p.ksp, p.shell ? p.shell : p.A, p.A), "the operators");
    check(KSPSetUp(p.ksp), "the levels");
}

Eigen::VectorXd Multigrid::solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    if (b.size() == 0 || b.isZero(0)) return x;
    const View from(b), to(x);
    check(KSPSolve(petsc_->ksp, from.get(), to.get()), "the iteration");
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    KSPGetConvergedReason(petsc_->ksp, &reason);
    if (reason <= 0)
        throw StepFailure(std::string("the linear iteration of the pressure does not converge: ") +
                          KSPConvergedReasons[reason]);
    return x;
}

int Multigrid::iterations() const {
    PetscInt n = 0;
    KSPGetIterationNumber(petsc_->ksp, &n);
    return static_cast<int>(n);
}

}  // namespace pfem
