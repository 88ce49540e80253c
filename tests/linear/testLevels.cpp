// Coarse matrices, sweeps and the cycle of a multigrid, against dense matrices.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <map>
#include <random>

#include "linear/levels.hpp"

using namespace pfem;

namespace {

/// The Laplacian of a square of m^2 places, random weights, unknowns shuffled; `more` on the diagonal of the first one
/// makes it definite. The last unknown meets no other.
SparseRows shuffledSquare(int m, double more) {
    const int n = m * m + 1;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> weight(0.5, 1.5);
    std::vector<int> at(m * m);
    for (int i = 0; i < m * m; ++i) at[i] = i;
    std::shuffle(at.begin(), at.end(), random);
    std::vector<std::map<int, double>> rows(n);
    const auto join = [&](int i, int j) {
        const double w = weight(random);
        rows[i][i] += w;
        rows[j][j] += w;
        rows[i][j] -= w;
        rows[j][i] -= w;
    };
    for (int y = 0; y < m; ++y)
        for (int x = 0; x < m; ++x) {
            if (x + 1 < m) join(at[y * m + x], at[y * m + x + 1]);
            if (y + 1 < m) join(at[y * m + x], at[(y + 1) * m + x]);
        }
    rows[0][0] += more;
    rows[n - 1][n - 1] = 2;
    SparseRows A;
    for (const auto& row : rows) {
        for (const auto& [column, value] : row) {
            A.column.push_back(column);
            A.value.push_back(value);
        }
        A.start.push_back(static_cast<int>(A.column.size()));
    }
    return A;
}

Eigen::MatrixXd dense(const SparseRows& A, int nColumns) {
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(A.n(), nColumns);
    for (int i = 0; i < A.n(); ++i)
        for (int s = A.start[i]; s < A.start[i + 1]; ++s) D(i, A.column[s]) += A.value[s];
    return D;
}

}  // namespace

/// Each row but the lone one is in an aggregate; those of five points have 5 to 13 rows, of which no two are further
/// than four links from each other.
TEST(Levels, aggregatesHoldNeighbours) {
    const SparseRows A = shuffledSquare(20, 1);
    const Aggregates joined = aggregates(A);
    EXPECT_EQ(joined.of.back(), -1);
    std::vector<int> size(joined.count, 0);
    for (int i = 0; i + 1 < A.n(); ++i) {
        ASSERT_GE(joined.of[i], 0);
        ++size[joined.of[i]];
    }
    EXPECT_GE(*std::min_element(size.begin(), size.end()), 3);  // a corner and its neighbours
    Eigen::MatrixXd reach = dense(A, A.n()).cwiseAbs();
    reach = (reach * reach).eval();
    reach = (reach * reach).eval();
    for (int i = 0; i + 1 < A.n(); ++i)
        for (int j = 0; j < i; ++j)
            if (joined.of[i] == joined.of[j]) {
                EXPECT_GT(reach(i, j), 0);
            }
}

/// Where rows sum to zero, constants come from constants; P^T A P.
TEST(Levels, coarseMatrixIsThatOfTheProlongation) {
    const SparseRows A = shuffledSquare(20, 1);
    const Aggregates joined = aggregates(A);
    const SparseRows P = prolongation(A, joined), R = transposed(P, joined.count);
    const Eigen::MatrixXd denseP = dense(P, joined.count), denseA = dense(A, A.n());
    EXPECT_LT((dense(R, A.n()) - denseP.transpose()).norm(), 1e-15);
    const Eigen::VectorXd one = denseP * Eigen::VectorXd::Ones(joined.count);
    for (int i = 1; i + 1 < A.n(); ++i) EXPECT_NEAR(one[i], 1, 1e-14) << i;
    EXPECT_EQ(one[A.n() - 1], 0);
    const Eigen::MatrixXd coarse = denseP.transpose() * denseA * denseP;
    EXPECT_LT((dense(coarseMatrix(A, P, R), joined.count) - coarse).norm(), 1e-14 * coarse.norm());
    // smoothed: functions one on an aggregate have less energy
    Eigen::MatrixXd unsmoothed = Eigen::MatrixXd::Zero(A.n(), joined.count);
    for (int i = 0; i + 1 < A.n(); ++i) unsmoothed(i, joined.of[i]) = 1;
    EXPECT_LT(coarse.trace(), 0.5 * (unsmoothed.transpose() * denseA * unsmoothed).trace());
}

/// Two blocks of rows that meet everywhere: what the forward sweep leaves is b - A x, and the backward one is its
/// transpose: x.(M^{-T} y) = (M^{-1} x).y.
TEST(Levels, sweepsAreTransposed) {
    const SparseRows A = shuffledSquare(33, 1);
    const int n = A.n();
    ASSERT_GE(n, 1000);
    const BlockSweeps sweeps(A);
    const Eigen::VectorXd b = Eigen::VectorXd::Random(n), c = Eigen::VectorXd::Random(n);
    Eigen::VectorXd x(n), r(n), y = Eigen::VectorXd::Zero(n), t(n);
    sweeps.forward(b, x, r);
    EXPECT_LT((r - (b - dense(A, n) * x)).norm(), 1e-6 * b.norm());
    sweeps.backward(c, y, t);
    EXPECT_NEAR(c.dot(x), b.dot(y), 1e-12 * std::abs(c.dot(x)));
    const Eigen::VectorXd change = y;
    sweeps.backward(c + dense(A, n) * b, y = b, t);  // from b: the same change
    EXPECT_LT((y - b - change).norm(), 1e-5 * change.norm());
}

/// Symmetric, positive definite, and near enough: the eigenvalues of (cycle A) are between 0 and 1, the least 0.1.
TEST(Levels, cycleIsSymmetricAndNear) {
    const SparseRows A = shuffledSquare(20, 1);
    const int n = A.n();
    const Levels levels(A);
    Eigen::MatrixXd C(n, n);
    for (int j = 0; j < n; ++j) C.col(j) = levels.cycle(Eigen::VectorXd::Unit(n, j));
    EXPECT_LT((C - C.transpose()).norm(), 1e-12 * C.norm());
    const Eigen::VectorXd spectrum = (C * dense(A, n)).eval().eigenvalues().real();
    EXPECT_GT(spectrum.minCoeff(), 0.1);
    EXPECT_LT(spectrum.maxCoeff(), 1 + 1e-5);
}
