// Conjugate gradients against dense algebra, and what they refuse.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "linear/conjugateGradients.hpp"

using namespace pfem;

namespace {

template <int Dim>
Eigen::VectorXd flat(const Points<Dim>& r) {
    Eigen::VectorXd u(Dim * static_cast<Eigen::Index>(r.size()));
    for (std::size_t i = 0; i < r.size(); ++i) u.segment<Dim>(Dim * static_cast<Eigen::Index>(i)) = r[i];
    return u;
}

template <int Dim>
Points<Dim> points(const Eigen::VectorXd& u) {
    Points<Dim> r;
    for (Eigen::Index i = 0; i < u.size(); i += Dim) r.push_back(u.segment<Dim>(i));
    return r;
}

template <int Dim>
NodalOperator<Dim> operatorOf(const Eigen::MatrixXd& A) {
    return [A](const Points<Dim>& r) { return points<Dim>(A * flat<Dim>(r)); };
}

/// Symmetric with these eigenvalues.
Eigen::MatrixXd symmetric(const Eigen::VectorXd& eigenvalues) {
    std::mt19937 random(3);
    std::normal_distribution<double> value;
    const Eigen::Index n = eigenvalues.size();
    const Eigen::MatrixXd any = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return value(random); });
    const Eigen::MatrixXd Q = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(any + any.transpose()).eigenvectors();
    return Q * eigenvalues.asDiagonal() * Q.transpose();
}

template <int Dim>
void solvesLikeDense() {
    const int n = 12 * Dim;
    const Eigen::MatrixXd A = symmetric(Eigen::VectorXd::LinSpaced(n, 0.1, 50));
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 3).array().cos();
    const Eigen::MatrixXd jacobi = A.diagonal().cwiseInverse().asDiagonal();
    const auto solution =
        conjugateGradients<Dim>(operatorOf<Dim>(A), operatorOf<Dim>(jacobi), points<Dim>(b), {1e-12, 200, "test"});
    EXPECT_LT((flat<Dim>(solution.x) - A.fullPivLu().solve(b)).norm(), 1e-9);
    EXPECT_GT(solution.iterations, 5);
}
TEST(ConjugateGradients, solvesLikeDense) {
    solvesLikeDense<2>();
    solvesLikeDense<3>();
}

TEST(ConjugateGradients, asManyStepsAsDifferentEigenvalues) {
    Eigen::VectorXd eigenvalues = Eigen::VectorXd::Constant(40, 2);
    eigenvalues.head(10).setConstant(7);
    eigenvalues.tail(10).setConstant(30);
    const Eigen::MatrixXd A = symmetric(eigenvalues), I = Eigen::MatrixXd::Identity(40, 40);
    const auto b = points<2>(Eigen::VectorXd::LinSpaced(40, 1, 2));
    EXPECT_EQ(conjugateGradients<2>(operatorOf<2>(A), operatorOf<2>(I), b, {1e-9, 100, "test"}).iterations, 3);
    const Eigen::MatrixXd inverse = A.inverse();  // the best preconditioner of all
    EXPECT_EQ(conjugateGradients<2>(operatorOf<2>(A), operatorOf<2>(inverse), b, {1e-9, 100, "test"}).iterations, 1);
}

TEST(ConjugateGradients, nothingToDo) {
    const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(4, 4);
    const auto solution = conjugateGradients<2>(operatorOf<2>(I), operatorOf<2>(I), points<2>(Eigen::VectorXd::Zero(4)),
                                                {1e-8, 10, "test"});
    EXPECT_EQ(solution.iterations, 0);
    EXPECT_EQ(flat<2>(solution.x).norm(), 0);
}

TEST(ConjugateGradients, saysWhoseMatrixItIs) {
    const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(20, 20);
    const auto b = points<2>(Eigen::VectorXd::LinSpaced(20, 1, 2));
    const auto failure = [&](const Eigen::MatrixXd& A, int most) -> std::string {
        try {
            conjugateGradients<2>(operatorOf<2>(A), operatorOf<2>(I), b, {1e-10, most, "momentum"});
        } catch (const StepFailure& reason) {
            return reason.what();
        }
        return "";
    };
    EXPECT_NE(failure(-I, 10).find("momentum matrix is not positive definite"), std::string::npos);
    EXPECT_NE(failure(symmetric(Eigen::VectorXd::LinSpaced(20, 1, 9)), 2).find("momentum did not converge"),
              std::string::npos);
    EXPECT_NE(failure(std::nan("") * I, 10), "");
}

}  // namespace
