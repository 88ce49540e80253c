// Direct solution of symmetric systems.

#include "linear/dissectedLdlt.hpp"
#include "linear/ldlt.hpp"
#include "linear/nestedDissection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "base/error.hpp"

using namespace pfem;

namespace {

/// Random sparse quasi-definite [H B; B^T -G] with nH + nG unknowns, and its dense twin.
struct QuasiDefinite {
    SymmetricMatrix A;
    Eigen::MatrixXd dense;
};

QuasiDefinite quasiDefinite(int nH, int nG, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    const int n = nH + nG;
    std::vector<std::vector<int>> lower(n);
    std::vector<std::array<int, 2>> entries;
    for (int j = 0; j < n; ++j)
        for (int i = j + 1; i < n; ++i)
            if (value(random) > 0.6) {
                lower[j].push_back(i);
                entries.push_back({i, j});
            }
    QuasiDefinite q{symmetricPattern(lower), Eigen::MatrixXd::Zero(n, n)};
    for (const auto& [i, j] : entries) {
        const double a = value(random);
        q.A.add(j, i, a);  // either triangle may be named
        q.dense(i, j) = q.dense(j, i) = a;
    }
    for (int i = 0; i < n; ++i) {
        double sum = 1;
        const bool first = i < nH;
        for (int j = 0; j < n; ++j)
            if ((j < nH) == first && j != i) sum += std::abs(q.dense(i, j));
        q.A.add(i, i, first ? sum : -sum);
        q.dense(i, i) = first ? sum : -sum;
    }
    return q;
}

TEST(Ldlt, quasiDefiniteAgainstDense) {
    for (const auto& [nH, nG] : {std::pair(40, 0), std::pair(0, 25), std::pair(40, 25), std::pair(1, 1)}) {
        const auto q = quasiDefinite(nH, nG, 3 + nH);
        Ldlt factor;
        factor.analyse(q.A);
        factor.factor(q.A);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(nH + nG, -1, 2);
        const Eigen::VectorXd exact = q.dense.fullPivLu().solve(b);
        EXPECT_LT((factor.solve(b) - exact).norm(), 1e-12 * exact.norm()) << nH << " " << nG;
        EXPECT_LT((q.A.multiply(b) - q.dense * b).norm(), 1e-13);
    }
}

TEST(Ldlt, newValuesOnTheSamePattern) {
    auto q = quasiDefinite(30, 20, 5);
    Ldlt factor;
    factor.analyse(q.A);
    factor.factor(q.A);
    for (double& value : q.A.value) value *= 2;
    factor.factor(q.A);
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(50);
    EXPECT_LT((2 * q.dense * factor.solve(b) - b).norm(), 1e-12);
}

/// The first columns of the lower triangle; rows in any order will do.
LowerColumns lowerColumns(const Eigen::MatrixXd& A, int nColumns) {
    LowerColumns columns;
    columns.n = static_cast<int>(A.rows());
    columns.start.push_back(0);
    for (int j = 0; j < nColumns; ++j) {
        for (int i = columns.n - 1; i >= j; --i) {
            if (A(i, j) == 0) continue;
            columns.row.push_back(i);
            columns.value.push_back(A(i, j));
        }
        columns.start.push_back(static_cast<int>(columns.row.size()));
    }
    return columns;
}

/// A chain of pieces, each parted from the next by nothing.
std::vector<Piece> pieces(int n, int width) {
    std::vector<Piece> chain;
    for (int first = 0; first < n; first += width)
        chain.push_back({first, std::min(width, n - first), first > 0 ? 1 : 0});
    return chain;
}

class MultifrontalLast : public testing::TestWithParam<int> {};

TEST_P(MultifrontalLast, unknownsAreTheSchurComplement) {
    const int nLast = GetParam();
    const auto q = quasiDefinite(30, 20, 8);
    const int n = q.A.n, nFirst = n - nLast;
    Multifrontal<double> factor;
    factor.factorize(lowerColumns(q.dense, nFirst), pieces(nFirst, 3));
    const Eigen::MatrixXd Aff = q.dense.topLeftCorner(nFirst, nFirst);
    const Eigen::MatrixXd Alf = q.dense.bottomLeftCorner(nLast, nFirst);
    const Eigen::MatrixXd exact =
        q.dense.bottomRightCorner(nLast, nLast) - Alf * Aff.fullPivLu().solve(Alf.transpose());
    const Eigen::MatrixXd block = factor.lastBlock() + q.dense.bottomRightCorner(nLast, nLast);
    EXPECT_LE((block - exact).norm(), 1e-12 * exact.norm());

    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
    Eigen::VectorXd x = b;
    factor.eliminate(x);
    if (nLast > 0) x.tail(nLast) = exact.fullPivLu().solve(Eigen::VectorXd(x.tail(nLast)));
    factor.backSubstitute(x);
    EXPECT_LT((q.dense * x - b).norm(), 1e-11);
}
INSTANTIATE_TEST_SUITE_P(Few, MultifrontalLast, testing::Values(0, 1, 7, 49));

/// An arrow, a chain, and pieces that do not meet: trees with one long branch, with many leaves, and forests.
TEST(Multifrontal, treesOfAllShapes) {
    const int n = 40;
    std::vector<Piece> leaves;
    for (int first = 0; first < 35; first += 5) leaves.push_back({first, 5, 0});
    leaves.push_back({35, 5, 7});
    for (const std::string shape : {"arrow", "chain", "apart", "full"}) {
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
        for (int i = 0; i < n; ++i) {
            dense(i, i) = 40 + i;
            for (int j = 0; j < i; ++j)
                if ((shape == "arrow" && i == n - 1) || (shape == "chain" && j == i - 1) ||
                    (shape == "apart" && i / 5 == j / 5) || shape == "full")
                    dense(i, j) = dense(j, i) = std::sin(i + 3.0 * j);
        }
        Multifrontal<double> factor;
        factor.factorize(lowerColumns(dense, n), shape == "apart" || shape == "arrow" ? leaves : pieces(n, 4));
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
        Eigen::VectorXd x = b;
        factor.eliminate(x);
        factor.backSubstitute(x);
        EXPECT_LT((dense * x - b).norm(), 1e-12) << shape;
    }
}

TEST(Multifrontal, noPivotNoFactor) {
    LowerColumns A{2, {0, 2, 3}, {0, 1, 1}, {1, 2, 4}};  // [1 2; 2 4] is singular
    EXPECT_THROW(Multifrontal<double>().factorize(A, {{0, 2, 0}}), StepFailure);
    EXPECT_THROW(Multifrontal<double>().factorize(A, {{0, 1, 0}, {1, 1, 1}}), StepFailure);
    A.value = {std::nan(""), 2, 4};
    EXPECT_THROW(Multifrontal<double>().factorize(A, {{0, 2, 0}}), StepFailure);
}

TEST(DissectedLdlt, anyPartsGiveTheSolution) {
    for (const int nParts : {1, 2, 3}) {
        const auto q = quasiDefinite(30, 20, 9);
        std::vector<Eigen::Vector2d> place;
        for (int i = 0; i < 50; ++i) place.emplace_back(std::cos(i), 2.0 * std::sin(5.0 * i));
        const auto part = slabs<2>(place, nParts, 1);
        for (int p = 0; p < nParts; ++p) EXPECT_NEAR(std::count(part.begin(), part.end(), p), 50.0 / nParts, 1);
        DissectedLdlt<2, double> factor(place, part, nParts);
        factor.analyse(q.A);
        factor.factor(q.A);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(50, -1, 2);
        EXPECT_LT((q.dense * factor.solve(b) - b).norm(), 1e-11) << nParts;
    }
}

TEST(DissectedLdlt, keptInSinglePrecision) {
    const auto q = quasiDefinite(30, 20, 9);
    Places<2> place;
    for (int i = 0; i < 50; ++i) place.emplace_back(std::cos(i), 2.0 * std::sin(5.0 * i));
    DissectedLdlt<2, float> factor(place, slabs<2>(place, 2, 1), 2);
    factor.analyse(q.A);
    factor.factor(q.A);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(50, -1, 2);
    Eigen::VectorXd x = factor.solve(b);
    EXPECT_LT((q.dense * x - b).norm(), 1e-6 * b.norm());
    for (int n = 0; n < 2; ++n) x -= factor.solve(q.dense * x - b);  // what an iteration makes of it
    EXPECT_LT((q.dense * x - b).norm(), 1e-13);
}

TEST(DissectedLdlt, apartAndEmptyParts) {
    auto A = symmetricPattern({{1}, {}, {3}, {}});  // two pairs that do not meet
    for (int i = 0; i < 4; ++i) A.add(i, i, 2);
    A.add(0, 1, 1);
    A.add(2, 3, -1);
    const Places<2> place{{0, 0}, {1, 0}, {2, 0}, {3, 1}};
    for (const auto& part : {std::vector<int>{0, 0, 1, 1}, {1, 1, 1, 1}, {0, 1, 0, 1}}) {
        DissectedLdlt<2, double> factor(place, part, 2);
        factor.analyse(A);
        factor.factor(A);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(4, 1, 4);
        EXPECT_LT((A.multiply(factor.solve(b)) - b).norm(), 1e-13);
    }
}

/// Entries of L of a matrix with this graph, eliminated in this order.
int fill(const MatrixGraph& graph, const std::vector<int>& order) {
    const int n = static_cast<int>(order.size());
    std::vector<int> position(n);
    for (int k = 0; k < n; ++k) position[order[k]] = k;
    std::vector<std::set<int>> later(n);
    for (int k = 0; k < n; ++k)
        for (int s = graph.start[order[k]]; s < graph.start[order[k] + 1]; ++s)
            if (position[graph.neighbour[s]] > k) later[k].insert(position[graph.neighbour[s]]);
    int entries = 0;
    for (int k = 0; k < n; ++k) {
        entries += static_cast<int>(later[k].size());
        if (later[k].empty()) continue;
        const int parent = *later[k].begin();
        later[parent].insert(std::next(later[k].begin()), later[k].end());
    }
    return entries;
}

/// m x m places, neighbours along both axes and one diagonal: a mesh of triangles.
MatrixGraph squareOfTriangles(int m) {
    MatrixGraph graph;
    graph.start.push_back(0);
    for (int i = 0; i < m * m; ++i) {
        const int x = i % m, y = i / m;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}})
            if (x + dx >= 0 && x + dx < m && y + dy >= 0 && y + dy < m) graph.neighbour.push_back(i + dx + m * dy);
        graph.start.push_back(static_cast<int>(graph.neighbour.size()));
    }
    return graph;
}

TEST(NestedDissection, littleFillOnASquare) {
    const int m = 40;
    const MatrixGraph graph = squareOfTriangles(m);
    Places<2> place;
    for (int i = 0; i < m * m; ++i) place.push_back({i % m, i / m});  // many are equally far along
    const auto order = nestedDissection<2>(graph, place).order;
    auto sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (int i = 0; i < m * m; ++i) ASSERT_EQ(sorted[i], i);  // each once
    std::vector<int> rowByRow(m * m);
    std::iota(rowByRow.begin(), rowByRow.end(), 0);
    EXPECT_LT(fill(graph, order), 0.6 * fill(graph, rowByRow));
    EXPECT_LT(fill(graph, order), 24 * m * m);
}

// Far from the origin (geodetic coordinates) places have round-off of their own.
TEST(NestedDissection, farFromTheOrigin) {
    const int m = 60;
    const MatrixGraph graph = squareOfTriangles(m);
    for (const double offset : {1e3, 1e5, 1e7})
        for (const double angle : {0.1, 0.7, 1.9}) {
            Places<2> place;
            const Eigen::Rotation2Dd turn(angle);
            for (int i = 0; i < m * m; ++i)
                place.push_back(turn * (1e-3 * Eigen::Vector2d(i % m, i / m)) + Eigen::Vector2d(offset, 2 * offset));
            const auto [order, pieces] = nestedDissection<2>(graph, place);
            LowerColumns A;
            A.n = m * m;
            std::vector<int> label(m * m);
            for (int k = 0; k < m * m; ++k) label[order[k]] = k;
            A.start.push_back(0);
            for (int k = 0; k < m * m; ++k) {
                A.row.push_back(k);
                for (int s = graph.start[order[k]]; s < graph.start[order[k] + 1]; ++s)
                    if (label[graph.neighbour[s]] > k) A.row.push_back(label[graph.neighbour[s]]);
                A.start.push_back(static_cast<int>(A.row.size()));
            }
            A.value.assign(A.row.size(), 0.0);
            EXPECT_NO_THROW(makeFronts(A, pieces)) << offset << " " << angle;
        }
}

/// What a piece parts does not meet: an entry leads from a piece only to those that part it, or into itself.
TEST(NestedDissection, piecesMeetOnlyThoseThatPartThem) {
    for (const double wave : {0.0, 0.7}) {  // straight, and places without any order
        const int m = 25;
        const MatrixGraph graph = squareOfTriangles(m);
        Places<2> place;
        for (int i = 0; i < m * m; ++i) {
            const int row = i / m;
            place.emplace_back(i % m + wave * std::sin(37.0 * i),
                               (wave > 0 ? 3 : 1) * (row + wave * std::cos(11.0 * i)));
        }
        const auto [order, pieces] = nestedDissection<2>(graph, place);
        std::vector<int> pieceOf(m * m), parent(pieces.size(), -1), stack;
        int columns = 0;
        for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
            EXPECT_EQ(pieces[p].first, columns);
            columns += pieces[p].width;
            for (int k = 0; k < pieces[p].width; ++k) pieceOf[order[pieces[p].first + k]] = p;
            for (int c = 0; c < pieces[p].nChildren; ++c, stack.pop_back()) parent[stack.back()] = p;
            stack.push_back(p);
        }
        EXPECT_EQ(columns, m * m);
        EXPECT_EQ(stack.size(), 1u);
        EXPECT_GT(pieces.size(), 60u);
        EXPECT_LE(pieces.back().width, m + 2);  // the first cut
        for (int i = 0; i < m * m; ++i)
            for (int s = graph.start[i]; s < graph.start[i + 1]; ++s) {
                const int other = pieceOf[graph.neighbour[s]];
                int p = pieceOf[i];
                while (p >= 0 && p < other) p = parent[p];
                EXPECT_TRUE(p == other || other < pieceOf[i]) << i;
            }
    }
}

TEST(Ldlt, singularMatrixFailsTheStep) {
    auto A = symmetricPattern({{1}, {}, {}});  // rows 0 and 1 alike, row 2 apart
    A.add(0, 0, 1);
    A.add(1, 0, 1);
    A.add(1, 1, 1);
    A.add(2, 2, 1);
    Ldlt factor;
    factor.analyse(A);
    EXPECT_THROW(factor.factor(A), StepFailure);
    A.add(1, 1, 1);  // mended: the object can be used again
    factor.factor(A);
    EXPECT_LT((factor.solve(Eigen::Vector3d(1, 1, 1)) - Eigen::Vector3d(1, 0, 1)).norm(), 1e-14);
}

TEST(Ldlt, zeroRowFailsTheStep) {
    auto A = symmetricPattern({{1}, {}});
    A.add(0, 0, 1);
    Ldlt factor;
    factor.analyse(A);
    EXPECT_THROW(factor.factor(A), StepFailure);
}

TEST(Ldlt, notANumberFailsTheStep) {
    auto A = symmetricPattern({{1}, {}});
    A.add(0, 0, std::numeric_limits<double>::quiet_NaN());
    A.add(1, 1, 1);
    Ldlt factor;
    factor.analyse(A);
    EXPECT_THROW(factor.factor(A), StepFailure);
}

TEST(SymmetricMatrix, entryOutsideThePattern) {
    auto A = symmetricPattern({{1}, {}, {}});
    EXPECT_THROW(A.add(2, 0, 1), InternalError);
}

}  // namespace
