// Options structs: reading, ranges and the keyword reference.

#include <gtest/gtest.h>

#include "dictionary/entries.hpp"

using namespace pfem;

namespace {

struct Options {
    double tolerance = 1e-4;
    int maxIterations = 40;
    bool adjust = false;
    std::string norm = "L2";
    Eigen::Vector3d g{0, -9.81, 0};
    std::vector<double> weights{0.5, 1};
    double deltaT = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v("tolerance", tolerance, "-", "when to stop", positive);
        v("maxIterations", maxIterations, "-", "how often", atLeast(1));
        v("adjust", adjust, "-", "whether");
        v("norm", norm, "-", "which norm", oneOf({"L2", "max"}));
        v("g", g, "m/s^2", "gravity");
        v("weights", weights, "-", "how much", between(0, 1));
        v.required("deltaT", deltaT, "s", "time step", nonNegative);
    }
};

void expectError(const std::string& text, int line, const std::string& part) {
    try {
        readEntries<Options>(Dictionary::parse(text, "file"));
        FAIL() << text;
    } catch (const UserError& error) {
        EXPECT_EQ(error.where().file, "file");
        EXPECT_EQ(error.where().line, line) << text;
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

}  // namespace

TEST(Entries, readsAndKeepsDefaults) {
    const auto options = readEntries<Options>(
        Dictionary::parse("tolerance 1e-6; adjust on; norm max; g (0 0 -1); weights (0 0.25); deltaT 0;"));
    EXPECT_EQ(options.tolerance, 1e-6);
    EXPECT_EQ(options.maxIterations, 40);
    EXPECT_TRUE(options.adjust);
    EXPECT_EQ(options.norm, "max");
    EXPECT_EQ(options.g, Eigen::Vector3d(0, 0, -1));
    EXPECT_EQ(options.weights, (std::vector<double>{0, 0.25}));
}

TEST(Entries, ranges) {
    expectError("deltaT 1;\ntolerance 0;", 2,
                "Entry 'tolerance' in dictionary \"file\" is out of range: 0, should be > 0");
    expectError("deltaT 1;\n\nmaxIterations 0;", 3, "should be >= 1");
    expectError("deltaT 1;\nweights (0 2);", 2, "should be 0 to 1");
    expectError("deltaT -1;", 1, "should be >= 0");
    expectError("deltaT 1;\nnorm L3;", 2, "did you mean 'L2'?");
    expectError("tolerance 1;", 1, "Entry 'deltaT' not found");
}

TEST(Entries, description) {
    const auto rows = describeEntries<Options>();
    ASSERT_EQ(rows.size(), 7u);
    EXPECT_EQ(rows[0].name + rows[0].type + rows[0].defaultValue + rows[0].range, "tolerancescalar0.0001> 0");
    EXPECT_EQ(rows[2].type + rows[2].defaultValue, "boolno");
    EXPECT_EQ(rows[3].type + rows[3].defaultValue + rows[3].range, "wordL2one of: L2 max");
    EXPECT_EQ(rows[4].type + rows[4].unit + rows[4].defaultValue, "vectorm/s^2(0 -9.81 0)");
    EXPECT_EQ(rows[5].type + rows[5].defaultValue, "list of scalar(0.5 1)");
    EXPECT_EQ(rows[6].defaultValue, "required");
}
