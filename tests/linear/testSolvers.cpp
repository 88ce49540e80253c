// All direct solvers behind the one interface, our own and those of others, on the same matrices.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "linear/dissectedLdlt.hpp"
#include "linear/ldlt.hpp"
#include "linear/oracles.hpp"
#include "linear/solvers.hpp"

using namespace pfem;

namespace {

/// [K B; B^T -M] on a square of m x m places, neighbours along both axes and one diagonal: K and M positive definite,
/// the last nLast unknowns in M. With nLast = 0 positive definite, otherwise quasi-definite.
struct Sample {
    SymmetricMatrix A;
    Places<2> place;
};

Sample square(int m, int nLast) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> weight(0.1, 1);
    const int n = m * m;
    std::vector<std::vector<int>> lower(n);
    Sample sample;
    for (int i = 0; i < n; ++i) {
        const int x = i % m, y = i / m;
        sample.place.push_back({x, y});
        if (x + 1 < m) lower[i].push_back(i + 1);
        if (y + 1 < m) lower[i].push_back(i + m);
        if (x + 1 < m && y + 1 < m) lower[i].push_back(i + m + 1);
    }
    sample.A = symmetricPattern(lower);
    const auto sign = [&](int i) { return i < n - nLast ? 1 : -1; };
    for (int i = 0; i < n; ++i) sample.A.add(i, i, 1e-3 * sign(i));
    for (int j = 0; j < n; ++j)
        for (const int i : lower[j]) {
            const double w = weight(random);
            if (sign(i) == sign(j)) {
                sample.A.add(i, i, w * sign(i));
                sample.A.add(j, j, w * sign(j));
                sample.A.add(i, j, -w * sign(i));
            } else {
                sample.A.add(i, j, w);
            }
        }
    return sample;
}

using Solvers = std::vector<std::pair<std::string, std::unique_ptr<SymmetricSolver>>>;

Solvers solversFor(const Sample& sample, bool definite) {
    Solvers all;
    all.emplace_back("Ldlt", std::make_unique<Ldlt>());
    for (const int nParts : {1, 2, 4})
        all.emplace_back(
            "DissectedLdlt " + std::to_string(nParts),
            std::make_unique<DissectedLdlt<2, double>>(sample.place, slabs<2>(sample.place, nParts, 0), nParts));
    if (definite) all.emplace_back("CHOLMOD", std::make_unique<test::Cholmod>());
#ifdef PFEM_MUMPS
    all.emplace_back("MUMPS", std::make_unique<test::Mumps>());
#endif
    return all;
}

Eigen::MatrixXd denseOf(const SymmetricMatrix& A) {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(A.n, A.n);
    for (int j = 0; j < A.n; ++j)
        for (int s = A.start[j]; s < A.start[j + 1]; ++s) dense(A.row[s], j) = dense(j, A.row[s]) = A.value[s];
    return dense;
}

TEST(SymmetricSolver, allGiveTheDenseSolution) {
    for (const int nLast : {0, 20, 119}) {
        const Sample sample = square(12, nLast);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(sample.A.n, -1, 2).array().sin();
        const Eigen::VectorXd exact = denseOf(sample.A).fullPivLu().solve(b);
        for (const auto& [name, solver] : solversFor(sample, nLast == 0)) {
            solver->analyse(sample.A);
            solver->factor(sample.A);
            EXPECT_LT((solver->solve(b) - exact).norm(), 1e-10 * exact.norm()) << name << " " << nLast;
        }
    }
}

TEST(SymmetricSolver, residualsOfLargeMatrices) {
    for (const int nLast : {0, 2000}) {
        const Sample sample = square(90, nLast);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(sample.A.n, 0, 40).array().cos();
        Eigen::VectorXd first;
        for (const auto& [name, solver] : solversFor(sample, nLast == 0)) {
            solver->analyse(sample.A);
            solver->factor(sample.A);
            const Eigen::VectorXd x = solver->solve(b);
            EXPECT_LT((sample.A.multiply(x) - b).norm(), 1e-10 * b.norm()) << name << " " << nLast;
            if (first.size() == 0) first = x;
            EXPECT_LT((x - first).norm(), 1e-8 * first.norm()) << name << " " << nLast;
        }
    }
}

/// A factor that is kept, and one that is computed in single precision: good to so many digits of the residual.
TEST(SymmetricSolver, singlePrecision) {
    const Sample sample = square(90, 2000);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(sample.A.n, 0, 40).array().cos();
    const auto residual = [&](auto&& solver) {
        solver.analyse(sample.A);
        solver.factor(sample.A);
        return (sample.A.multiply(solver.solve(b)) - b).norm() / b.norm();
    };
    const auto part = slabs<2>(sample.place, 2, 0);
    const double kept = residual(DissectedLdlt<2, float>(sample.place, part, 2)),
                 throughout = residual(DissectedLdlt<2, float, float>(sample.place, part, 2));
    EXPECT_LT(kept, 1e-5);
    EXPECT_GT(kept, 1e-9);
    EXPECT_LT(throughout, 1e-5);
    EXPECT_GT(throughout, 1e-9);
}

// Rounding errors grow with the ratio of stiffness to inertia: only below 1000 is the factor computed in single
// precision.
TEST(SymmetricSolver, stiffSolidsAreFactoredInDoublePrecision) {
    const Sample sample = square(40, 500);
    Places<3> place;
    for (const auto& at : sample.place) place.emplace_back(at[0], at[1], 0);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(sample.A.n, 0, 40).array().cos();
    const auto solution = [&](auto solver) {
        solver->analyse(sample.A);
        solver->factor(sample.A);
        return Eigen::VectorXd(solver->solve(b));
    };
    const auto kept = solution(dissectedSolver<3>(sample.A, place, Precision::single)),
               throughout = solution(dissectedSolver<3>(sample.A, place, Precision::singleThroughout));
    EXPECT_NE(kept, throughout);
    EXPECT_EQ(solution(elasticSolver<3>(sample.A, place, 999)), throughout);
    EXPECT_EQ(solution(elasticSolver<3>(sample.A, place, 1001)), kept);
}

TEST(SymmetricSolver, newValuesOnTheSamePattern) {
    Sample sample = square(20, 60);
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(sample.A.n);
    for (const auto& [name, solver] : solversFor(sample, false)) {
        solver->analyse(sample.A);
        solver->factor(sample.A);
        const Eigen::VectorXd before = solver->solve(b);
        SymmetricMatrix twice = sample.A;
        for (double& value : twice.value) value *= 2;
        solver->factor(twice);
        EXPECT_LT((2 * solver->solve(b) - before).norm(), 1e-10 * before.norm()) << name;
        solver->factor(sample.A);
        EXPECT_EQ(solver->solve(b), before) << name;  // to the bit
    }
}

/// A bar of 5 x 10 x 24 places, in which those up to two steps away along each axis meet, as with nodal integration.
std::pair<SymmetricMatrix, Places<3>> bar() {
    constexpr int nx = 5, ny = 10, nz = 24;
    Places<3> place;
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) place.push_back(Eigen::Vector3d(x, y, z));
    std::vector<std::vector<int>> lower(place.size());
    for (std::size_t i = 0; i < place.size(); ++i)
        for (std::size_t j = i + 1; j < place.size(); ++j)
            if ((place[j] - place[i]).cwiseAbs().maxCoeff() <= 2) lower[i].push_back(static_cast<int>(j));
    return {symmetricPattern(lower), place};
}

/// Unknowns of each part that meet no other part above.
std::vector<int> insides(const SymmetricMatrix& A, const std::vector<int>& part, int nParts) {
    const auto shared = sharedUnknowns(A, part);
    std::vector<int> count(nParts, 0);
    for (int i = 0; i < A.n; ++i) count[part[i]] += shared[i] == 0;
    return count;
}

}  // namespace

TEST(EqualSlabs, whatIsBetweenThemIsOfNone) {
    const auto [A, place] = bar();
    for (const int nParts : {2, 3}) {
        const auto uneven = insides(A, slabs<3>(place, nParts, 2), nParts);
        const auto even = insides(A, equalSlabs<3>(A, place, nParts), nParts);
        const auto spread = [](const std::vector<int>& count) {
            const auto [least, most] = std::minmax_element(count.begin(), count.end());
            return *most - *least;
        };
        EXPECT_GE(spread(uneven), 100) << nParts;  // two layers of fifty
        EXPECT_LE(spread(even), 50) << nParts;     // one
    }
}
