#include "study/sampling.hpp"

#include "case/timeFolders.hpp"
#include "sweepCase.hpp"

namespace pfem {
namespace {

using test::parameters;
using test::tip;
using Rows = std::vector<std::vector<std::string>>;

class Sampling : public test::SweepFolder {};

const std::string stiffness = R"(stiffness { file "constant/materials"; entry "rubber/E"; values (1e6 2e6); } )";

TEST_F(Sampling, gridHasAllCombinations) {
    const auto sweep =
        sweepOf("method grid;" + tip +
                parameters(stiffness + R"(size { file "common"; entry h; range (0.1 0.4); count 3; scale log; }
        g { file "constant/g"; entry value; values ((0 -9.81 0) (0 -1.6 0)); })"));
    const Rows table = sampleCases(sweep);
    ASSERT_EQ(table.size(), 12u);
    EXPECT_EQ(table[0], (std::vector<std::string>{"1e6", "0.1", "( 0 -9.81 0 )"}));
    EXPECT_EQ(table[1], (std::vector<std::string>{"1e6", "0.1", "( 0 -1.6 0 )"}));
    EXPECT_EQ(table[2][1], "0.2");  // the middle in the logarithm
    EXPECT_EQ(table[11], (std::vector<std::string>{"2e6", "0.4", "( 0 -1.6 0 )"}));
    EXPECT_EQ(std::set<std::vector<std::string>>(table.begin(), table.end()).size(), 12u);
}

TEST_F(Sampling, listGoesThroughAllTogether) {
    const Rows table = sampleCases(
        sweepOf("method list;" + tip + parameters(stiffness + R"(law { file "a"; entry b; values (nodal "x y"); })")));
    EXPECT_EQ(table, (Rows{{"1e6", "nodal"}, {"2e6", "\"x y\""}}));
}

TEST_F(Sampling, listOfUnequalLengths) {
    const auto sweep =
        sweepOf("method list;" + tip + parameters(stiffness + R"(h { file a; entry b; values (1 2 3); })"));
    EXPECT_NE(complaint([&] { sampleCases(sweep); }).find("'stiffness' has 2 values, 'h' has 3"), std::string::npos);
}

TEST_F(Sampling, rangeWithoutCount) {
    const auto sweep = sweepOf("method grid;" + tip + parameters("h { file a; entry b; range (1 2); }"));
    EXPECT_NE(complaint([&] { sampleCases(sweep); }).find("count"), std::string::npos);
}

std::string hypercube(int samples, int seed) {
    return "method latinHypercube; samples " + std::to_string(samples) + "; seed " + std::to_string(seed) + ";" + tip +
           parameters(R"(a { file f; entry a; range (-1 3); }
                         b { file f; entry b; range (1e-4 1e4); scale log; }
                         c { file f; entry c; values (x y z); })");
}

// One sample in each of n equally wide parts of every range; words equally often.
TEST_F(Sampling, latinHypercubeIsStratified) {
    for (const int n : {1, 2, 7, 12, 300}) {
        const auto sweep = sweepOf(hypercube(n, n));
        const Rows table = sampleCases(sweep);
        ASSERT_EQ(table.size(), static_cast<std::size_t>(n));
        std::set<int> partsOfA, partsOfB;
        std::map<std::string, int> words;
        for (const auto& row : table) {
            const double a = *asNumber(row[0]), b = *asNumber(row[1]);
            partsOfA.insert(static_cast<int>(std::floor(n * (a + 1) / 4)));
            partsOfB.insert(static_cast<int>(std::floor(n * (std::log10(b) + 4) / 8)));
            ++words[row[2]];
            EXPECT_GE(a, -1);
            EXPECT_LE(b, 1e4);
        }
        EXPECT_EQ(partsOfA.size(), static_cast<std::size_t>(n));
        EXPECT_EQ(partsOfB.size(), static_cast<std::size_t>(n));
        EXPECT_EQ(*partsOfA.begin(), 0);
        EXPECT_EQ(*partsOfA.rbegin(), n - 1);
        if (n % 3 == 0) {
            for (const char* word : {"x", "y", "z"}) EXPECT_EQ(words[word], n / 3);
        }
    }
}

TEST_F(Sampling, latinHypercubeIsDecidedByItsSeed) {
    const Rows first = sampleCases(sweepOf(hypercube(12, 1)));
    EXPECT_EQ(first, sampleCases(sweepOf(hypercube(12, 1))));
    const Rows other = sampleCases(sweepOf(hypercube(12, 2)));
    EXPECT_NE(first, other);
    // the parts come in another order for each parameter: a and b are not the same permutation
    const auto order = [](Rows table, std::size_t column) {
        std::vector<int> rank(table.size());
        for (std::size_t i = 0; i < table.size(); ++i)
            for (const auto& row : table) rank[i] += *asNumber(row[column]) < *asNumber(table[i][column]);
        return rank;
    };
    EXPECT_NE(order(first, 0), order(first, 1));
    EXPECT_EQ(first[0][0], sampleCases(sweepOf(hypercube(12, 1)))[0][0]);
}

}  // namespace
}  // namespace pfem
