#include "study/result.hpp"

#include <cmath>
#include <limits>

#include "sweepCase.hpp"

namespace pfem {
namespace {

constexpr double dry = std::numeric_limits<double>::quiet_NaN();

class Results : public test::SweepFolder {
protected:
    Results() {
        put("postProcessing/tip/0/D", "# Probe 0 (0 0 0)\n# Time\n0 (0 1 0)\n1 (3 5 0)\n2 (1 4 0)\n");
        put("postProcessing/tip/0/U", "# Probe 0 (0 0 0)\n# Time\n0 (0 1 0)\n");
        put("postProcessing/level/0/height.dat", "# Time height\n0 2\n1 3\n");
    }
    double in(const std::string& text) const { return valueIn(resultOf(text), root, 10); }
    static Result resultOf(const std::string& text) { return readResult(Dictionary::parse(text, "sweepDict")); }
};

TEST_F(Results, ofACurve) {
    const Curve curve{{0, 1, 2, 4, 5}, {1, 4, dry, -2, 7}};
    const auto of = [&](const std::string& value, double until) {
        return valueOf(resultOf("function f; value " + value + ";"), curve, until);
    };
    EXPECT_EQ(of("max", 5), 7);
    EXPECT_EQ(of("max", 4), 4);
    EXPECT_EQ(of("min", 5), -2);
    EXPECT_EQ(of("timeOfMax", 4), 1);
    EXPECT_EQ(of("timeOfMin", 5), 4);
    EXPECT_EQ(of("last", 4), -2);
    EXPECT_DOUBLE_EQ(of("mean", 1), 2.5);
    EXPECT_DOUBLE_EQ(of("mean", 4), (2.5 * 1 + 1 * 3) / 4);  // straight over the dry sample
    EXPECT_DOUBLE_EQ(of("at; time 0.5", 5), 2.5);
    EXPECT_TRUE(std::isnan(of("at; time 1.5", 5)));
    EXPECT_TRUE(std::isnan(valueOf(resultOf("function f;"), {{0}, {dry}}, 1)));
}

TEST_F(Results, ofATable) {
    EXPECT_EQ(in("function tip; file D; column D_y;"), 5);
    EXPECT_EQ(in("function level;"), 3);  // the only file, the only column
}

TEST_F(Results, whatIsNotThere) {
    const auto says = [&](const std::string& text) { return complaint([&] { in(text); }); };
    EXPECT_NE(says("function tip; column D_y;").find("needs an entry 'file'. Valid are: D U"), std::string::npos);
    EXPECT_NE(says("function tip; file D;").find("D_x D_y D_z"), std::string::npos);
    EXPECT_NE(says("function tip; file D; column D_t;").find("D_x"), std::string::npos);
    EXPECT_NE(says("function tap; file D;").find("tap"), std::string::npos);
}

}  // namespace
}  // namespace pfem
