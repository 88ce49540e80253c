// Multigrid for the pressures of [K B; B^T -M] against a direct factor.

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <random>

#include "base/error.hpp"
#include "linear/dissectedLdlt.hpp"
#include "linear/multigridSolver.hpp"
#include "linear/solvers.hpp"

using namespace pfem;

namespace {

/// Pressures on m^3 places with the Laplacian of seven points and a little more on the diagonal; each place of the top
/// layer has a velocity, of mass `light`; those of the bottom layer are an elastic sheet of stiffness `stiff`.
struct Sample {
    SymmetricMatrix A;
    Places<3> place;
    SaddleSizes sizes;
};

Sample cube(int m, double light, double stiff) {
    const auto at = [m](int x, int y, int z) { return (z * m + y) * m + x; };
    const int nP = m * m * m, layer = m * m;
    Sample sample;
    sample.sizes = {nP, layer};
    std::vector<std::vector<int>> lower(nP + 2 * layer);
    for (int z = 0; z < m; ++z)
        for (int y = 0; y < m; ++y)
            for (int x = 0; x < m; ++x) {
                sample.place.emplace_back(x, y, z);
                auto& rows = lower[at(x, y, z)];
                if (x + 1 < m) rows.push_back(at(x + 1, y, z));
                if (y + 1 < m) rows.push_back(at(x, y + 1, z));
                if (z + 1 < m) rows.push_back(at(x, y, z + 1));
                if (z == 0) rows.push_back(nP + at(x, y, 0));
                if (z == m - 1) rows.push_back(nP + layer + at(x, y, 0));
            }
    for (const int z : {0, m - 1})
        for (int y = 0; y < m; ++y)
            for (int x = 0; x < m; ++x) {
                sample.place.emplace_back(x, y, z);
                if (z > 0) continue;
                if (x + 1 < m) lower[nP + at(x, y, 0)].push_back(nP + at(x + 1, y, 0));
                if (y + 1 < m) lower[nP + at(x, y, 0)].push_back(nP + at(x, y + 1, 0));
            }
    SymmetricMatrix& A = sample.A = symmetricPattern(lower);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> weight(0.5, 1.5);
    for (int j = 0; j < nP + layer; ++j) {
        const double sign = j < nP ? 1 : -stiff;
        A.add(j, j, 1e-3 * sign);
        for (int s = A.start[j] + 1; s < A.start[j + 1]; ++s) {
            const int i = A.row[s];
            if (j < nP && i >= nP) {
                A.add(i, j, weight(random));
                continue;
            }
            const double w = sign * weight(random);
            A.add(i, i, w);
            A.add(j, j, w);
            A.add(i, j, -w);
        }
    }
    for (int j = nP + layer; j < A.n; ++j) A.add(j, j, -light);
    return sample;
}

/// M of the elastic velocities, without its scale.
SymmetricMatrix elasticBlock(const Sample& s, double scale) {
    const auto [first, n] = s.sizes;
    SymmetricMatrix M;
    M.n = n;
    M.start.assign(1, 0);
    for (int j = first; j < first + n; ++j) {
        for (int k = s.A.start[j]; k < s.A.start[j + 1]; ++k) {
            M.row.push_back(s.A.row[k] - first);
            M.value.push_back(-s.A.value[k] / scale);
        }
        M.start.push_back(static_cast<int>(M.row.size()));
    }
    return M;
}

MultigridSolver multigridSolver(const Sample& s, double tolerance) {
    constexpr double scale = 0.5;
    const SymmetricMatrix M = elasticBlock(s, scale);
    const auto first = s.place.begin() + s.sizes.nPressures;
    std::shared_ptr<SymmetricSolver> factor = elasticSolver<3>(M, {first, first + s.sizes.nElastic}, 1e9);
    factor->analyse(M);
    factor->factor(M);
    return {s.sizes, {factor, scale}, tolerance, {}};
}

/// Pressures on m^3 places with the Laplacian of seven points, of which the eight of each cube move one light velocity:
/// weight (1 ... 1)^T (1 ... 1). In the order of their parity, so that the eight are far from each other among the
/// rows.
SparseRows lightVelocities(int m, double weight) {
    const int half = m / 2, n = m * m * m;
    const auto at = [half](const std::array<int, 3>& x) {
        const int parity = 4 * (x[2] % 2) + 2 * (x[1] % 2) + x[0] % 2;
        return parity * half * half * half + (x[2] / 2 * half + x[1] / 2) * half + x[0] / 2;
    };
    std::vector<std::map<int, double>> rows(n);
    for (int place = 0; place < n; ++place) {
        const std::array<int, 3> x{place % m, place / m % m, place / (m * m)};
        rows[at(x)][at(x)] += 1e-3;
        std::vector<int> cube;
        for (int k = 0; k < 8; ++k) {
            const std::array<int, 3> y{x[0] + k % 2, x[1] + k / 2 % 2, x[2] + k / 4};
            if (*std::max_element(y.begin(), y.end()) == m) continue;
            cube.push_back(at(y));
            if (k != 1 && k != 2 && k != 4) continue;
            for (const auto& [i, j] : {std::pair(at(x), at(y)), std::pair(at(y), at(x))}) {
                rows[i][i] += 1;
                rows[i][j] -= 1;
            }
        }
        for (const int i : cube)
            for (const int j : cube) rows[i][j] += weight;
    }
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

Eigen::VectorXd someRight(int n) {
    Eigen::VectorXd b(n);
    for (int i = 0; i < n; ++i) b[i] = std::sin(0.37 * i) + 0.2;
    return b;
}

}  // namespace

class MultigridOnCube : public testing::Test {
protected:
    void SetUp() override {
        if (!hasMultigrid()) GTEST_SKIP() << "a build without PETSc";
    }
};

/// All unknowns, right-hand sides of velocities included; soft sheets (stiffness 0.01) are the harder ones.
TEST_F(MultigridOnCube, agreesWithTheFactor) {
    for (const double stiff : {100.0, 1.0, 0.01}) {
        const Sample s = cube(10, 0.3, stiff);
        const auto direct = dissectedSolver<3>(s.A, s.place, Precision::twofold);
        MultigridSolver multigrid = multigridSolver(s, 1e-12);
        for (SymmetricSolver* solver : {direct.get(), static_cast<SymmetricSolver*>(&multigrid)}) {
            solver->analyse(s.A);
            solver->factor(s.A);
        }
        const Eigen::VectorXd b = someRight(s.A.n), x = direct->solve(b);
        EXPECT_LT((multigrid.solve(b) - x).norm(), 1e-8 * x.norm()) << "stiffness " << stiff;
        EXPECT_LT((s.A.multiply(x) - b).norm(), 1e-10 * b.norm());
        const Eigen::VectorXd ofPressures = b.head(s.sizes.nPressures), first = direct->solveFirst(ofPressures, s.A.n);
        EXPECT_LT((multigrid.solveFirst(ofPressures, s.A.n) - first).norm(), 1e-8 * first.norm());
    }
}

/// From 512 to 32768 pressures the same number of iterations but for four.
TEST_F(MultigridOnCube, iterationsDoNotGrowWithTheSize) {
    std::vector<int> iterations;
    for (const int m : {8, 16, 32}) {
        const Sample s = cube(m, 0.3, 1);
        Multigrid levels(1e-6);
        const Saddle saddle = split(s.A, {s.sizes.nPressures, 0});
        levels.setUp(eliminateDiagonal(saddle));
        levels.solve(someRight(s.sizes.nPressures));
        iterations.push_back(levels.iterations());
    }
    EXPECT_LE(iterations[2], iterations[0] + 4) << iterations[0] << ", " << iterations[1] << ", " << iterations[2];
    EXPECT_LE(iterations[2], 15);
}

/// Sweeps of blocks of rows that know nothing of each other do not overshoot, in whatever order unknowns are: else the
/// cycle were indefinite (a dam break with 47 000 pressures ended in steps of 5e-6 s).
TEST_F(MultigridOnCube, convergesInAnyOrder) {
    for (const double weight : {0.1, 1.0, 10.0}) {
        const SparseRows A = lightVelocities(16, weight);
        Multigrid levels(1e-6);
        levels.setUp(A);
        const Eigen::VectorXd b = someRight(A.n());
        ASSERT_NO_THROW(levels.solve(b)) << weight;
        std::cout << "weight " << weight << ": " << levels.iterations() << " iterations\n";
        EXPECT_LT((multiply(A, levels.solve(b)) - b).norm(), 1e-3 * b.norm());
    }
}

TEST_F(MultigridOnCube, repeatsItsBits) {
    const Sample s = cube(12, 0.3, 1);
    Eigen::VectorXd x[2];
    for (Eigen::VectorXd& each : x) {
        MultigridSolver solver = multigridSolver(s, 1e-3);
        solver.analyse(s.A);
        solver.factor(s.A);
        each = solver.solve(someRight(s.A.n));
    }
    EXPECT_EQ(x[0], x[1]);
}

/// 32768 pressures: sums of so many are shared by BLAS, too.
TEST_F(MultigridOnCube, bitsDoNotDependOnThreads) {
    const Sample s = cube(32, 0.3, 1);
    const int threads = omp_get_max_threads();
    Eigen::VectorXd x[2];
    for (const int n : {1, 3}) {
        omp_set_num_threads(n);
        MultigridSolver solver = multigridSolver(s, 1e-3);
        solver.analyse(s.A);
        solver.factor(s.A);
        x[n > 1] = solver.solve(someRight(s.A.n));
    }
    omp_set_num_threads(threads);
    EXPECT_EQ(x[0], x[1]);
    const auto ofBlas = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
    if (ofBlas) {
        EXPECT_EQ(ofBlas(), 1);
    }
}

TEST_F(MultigridOnCube, saysThatItDoesNotConverge) {
    Sample s = cube(6, 0.3, 1);
    for (int j = 0; j < s.sizes.nPressures; ++j) s.A.add(j, j, -8);  // no longer definite
    MultigridSolver solver = multigridSolver(s, 1e-10);
    solver.analyse(s.A);
    EXPECT_THROW(
        {
            solver.factor(s.A);
            solver.solve(someRight(s.A.n));
        },
        StepFailure);
}

/// K + B diag(M)^{-1} B^T by dense matrices.
TEST(Saddle, eliminatesDiagonalVelocities) {
    const Sample s = cube(3, 0.3, 1);
    const int nP = s.sizes.nPressures, nV = s.A.n - nP;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(s.A.n, s.A.n);
    for (int j = 0; j < s.A.n; ++j)
        for (int k = s.A.start[j]; k < s.A.start[j + 1]; ++k) A(s.A.row[k], j) = A(j, s.A.row[k]) = s.A.value[k];
    const Eigen::MatrixXd B = A.topRightCorner(nP, nV);
    const Eigen::VectorXd M = -A.diagonal().tail(nV);
    const Eigen::MatrixXd expected = A.topLeftCorner(nP, nP) + B * M.cwiseInverse().asDiagonal() * B.transpose();
    const SparseRows S = eliminateDiagonal(split(s.A, s.sizes));
    Eigen::MatrixXd found = Eigen::MatrixXd::Zero(nP, nP);
    for (int i = 0; i < nP; ++i)
        for (int k = S.start[i]; k < S.start[i + 1]; ++k) {
            found(i, S.column[k]) += S.value[k];
            if (k > S.start[i]) {
                EXPECT_LT(S.column[k - 1], S.column[k]);
            }
        }
    EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
}

/// A rank has its own rows from the columns that they meet: the others' are not made.
TEST(Saddle, eliminatesInSomeRowsAlone) {
    const Sample s = cube(5, 0.3, 1);
    const int nP = s.sizes.nPressures, first = nP / 3, last = nP / 2;
    const SparseRows whole = eliminateDiagonal(split(s.A, s.sizes));
    std::vector<unsigned char> isMet(nP, 0);
    for (int k = whole.start[first]; k < whole.start[last]; ++k) isMet[whole.column[k]] = 1;
    ASSERT_LT(std::count(isMet.begin(), isMet.end(), 1), nP);
    SymmetricMatrix A;
    A.n = s.A.n;
    A.start = {0};
    for (int j = 0; j < A.n; ++j) {
        for (int k = s.A.start[j]; k < s.A.start[j + 1] && (j >= nP || isMet[j]); ++k) {
            A.row.push_back(s.A.row[k]);
            A.value.push_back(s.A.value[k]);
        }
        A.start.push_back(static_cast<int>(A.row.size()));
    }
    const SparseRows rows = eliminateDiagonal(split(A, s.sizes), first, last);
    ASSERT_EQ(rows.n(), last - first);
    for (int i = 0; i < rows.n(); ++i) {
        const auto row = [](const SparseRows& of, int r) {
            return std::pair(std::vector<int>(of.column.begin() + of.start[r], of.column.begin() + of.start[r + 1]),
                             std::vector<double>(of.value.begin() + of.start[r], of.value.begin() + of.start[r + 1]));
        };
        EXPECT_EQ(row(rows, i), row(whole, first + i)) << i;
    }
}
